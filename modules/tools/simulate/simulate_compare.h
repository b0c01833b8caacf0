#pragma once

#include <cstdint>
#include <string>

namespace scanway::tools {

struct SimulateCompareOptions {
  std::string folder;  ///< Of scanway replay, over a log of the simulated robot.
  std::string world;
  std::uint64_t seed = 1;
  bool json = false;
};

/// `scanway simulate compare`: poses and cost map of a replayed log against the simulator's truth, on stdout and
/// in the folder's truth.json. Throws InputError.
int run_simulate_compare(const SimulateCompareOptions& options);

}  // namespace scanway::tools
