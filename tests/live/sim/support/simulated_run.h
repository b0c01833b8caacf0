#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace scanway::test {

/// A run of launch/sim, with what it has left in its folder.
class SimulatedRun {
 public:
  explicit SimulatedRun(const std::vector<std::string>& options);

  static std::string build();   ///< The folder with the programs.
  static std::string script();  ///< launch/sim

  const CommandResult& said() const { return said_; }
  /// What it has counted against the truth.
  nlohmann::json truth() const { return nlohmann::json::parse(read_text(folder_ / "truth.json")); }
  /// The pictures whose paths it ends with, if they are there.
  std::vector<std::string> pictures() const;
  CommandResult verify() const;
  /// Everything that helps to see what went wrong.
  std::string told() const { return said_.out + said_.err + read_text(folder_ / "processes.txt"); }

 private:
  const ScratchFolder folder_;
  CommandResult said_;
};

}  // namespace scanway::test
