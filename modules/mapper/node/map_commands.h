#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus.h"
#include "common/time/utime.h"
#include "scanway/map_answer_t.hpp"
#include "scanway/map_command_t.hpp"

namespace scanway {

/// Commands to the map: each is carried out once, however often it is said. Of a log whose MAP_ANSWERs are known, each
/// that was answered is carried out where it was then, between the same two sweeps, whenever it comes.
class MapCommands {
 public:
  /// Of the answers only those to commands that change the map.
  void use(std::vector<map_answer_t> answers);

  /// The command of a message, if it is to be carried out now. Throws BadMessage.
  std::optional<map_command_t> take(const BusMessage& message);
  /// Those that were carried out right after the sweep of that digest (0: before any), in their order; each once.
  std::vector<map_command_t> due(std::uint64_t sweep);

 private:
  using Name = std::pair<Utime, std::string>;
  static Name name_of(const map_command_t& command) { return {command.utime, command.sweep_name}; }

  std::set<Name> known_;
  std::vector<map_answer_t> answers_;
};

}  // namespace scanway
