#pragma once

#include <optional>
#include <string>
#include <utility>

namespace scanway::tools {

struct PlanOptions {
  std::string map;    ///< A map_server YAML.
  std::string robot;  ///< Robot file; empty: the built-in ERA-Mobi.
  std::pair<double, double> start_m;
  std::pair<double, double> goal_m;
  std::string mode = "footprint";  ///< point, paper or footprint.
  std::string unknown = "never";   ///< never, price or free.
  std::optional<bool> smooth;      ///< Nothing: in mode footprint.
  bool explain = false;            ///< Say what is in the way; then a start or goal in an obstacle is an answer too.
  std::string output;              ///< Folder for path.csv and path.png; empty: none.
  bool json = false;
};

/// `scanway plan`: a path on a map file. Returns 0 when there is a path or a plain answer that there is none.
/// Throws InputError, also for a start or goal in an obstacle or off the map.
int run_plan(const PlanOptions& options);

}  // namespace scanway::tools
