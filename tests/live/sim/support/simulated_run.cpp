#include "tests/live/sim/support/simulated_run.h"

#include <filesystem>
#include <sstream>

namespace scanway::test {

std::string SimulatedRun::build() { return std::filesystem::path(SCANWAY_BIN_DIR).parent_path(); }
std::string SimulatedRun::script() { return std::string(SCANWAY_SOURCE_DIR) + "/launch/sim"; }

SimulatedRun::SimulatedRun(const std::vector<std::string>& options) {
  std::vector<std::string> words{script(), "-o", folder_.path()};
  words.insert(words.end(), options.begin(), options.end());
  said_ = run_command(words, {"SCANWAY_BUILD=" + build()});
}

std::vector<std::string> SimulatedRun::pictures() const {
  std::vector<std::string> pictures;
  std::istringstream lines(said_.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(".png") && std::filesystem::exists(line)) pictures.push_back(line);
  }
  return pictures;
}

CommandResult SimulatedRun::verify() const {
  return run_command({build() + "/bin/scanway", "replay", "--verify", folder_ / "sim.lcm"});
}

}  // namespace scanway::test
