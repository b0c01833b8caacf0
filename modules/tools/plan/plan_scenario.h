#pragma once

#include <string>

namespace scanway::tools {

struct PlanScenarioOptions {
  std::string scenario;  ///< A .scen of Moving AI; its map lies beside it.
  bool json = false;
};

/// `scanway plan` with `--scen`: every problem of a scenario by Moving AI's own rule. Returns 0 when every path is as
/// long as the file says, to 0.01; 1 otherwise. Throws InputError.
int run_plan_scenario(const PlanScenarioOptions& options);

}  // namespace scanway::tools
