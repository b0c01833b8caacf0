#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace scanway::test {

/// Whether this machine lets us make network namespaces, in which these tests keep their packets.
bool namespaces_permitted();

/// A pretend machine with a folder: a loopback interface with a route for multicast, and no other network.
class Machine {
 public:
  /// Runs a shell script there, in the folder. LAUNCH: the launch scripts, SCANWAY: the command, PLAY: LCM's player.
  CommandResult run(const std::string& script) const;

  std::string path(const std::string& file) const { return folder_ / file; }
  std::string text(const std::string& file) const { return read_text(path(file)); }
  /// What `scanway info` says of a log in the folder; its status must be 0: the log is whole.
  nlohmann::json info(const std::string& log) const;

 private:
  const ScratchFolder folder_;
};

/// The entry of a channel in `channels` of `scanway info` or `scanway spy`; null if there is none.
nlohmann::json channel_of(const nlohmann::json& document, const std::string& channel);

/// A log of `seconds` with the utimes of evenly spaced messages: IMU at 50 Hz, of which every 40th is left out; HEALTH
/// at 1 Hz, and in the middle a GOAL that is cut off.
struct StreamLog {
  explicit StreamLog(const std::string& path, int seconds);
  std::uint64_t imus = 0;
  std::uint64_t left_out = 0;
};

/// A log of one sweep with its orientation and a goal: a scan of the hall, every 16th point of it.
void write_sweep_log(const std::string& folder, const std::string& log);

}  // namespace scanway::test
