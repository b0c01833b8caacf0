#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "modules/schunk_bridge/core/message.h"
#include "modules/schunk_bridge/core/reply.h"

namespace scanway::schunk {

/// A named part of what was read.
struct Field {
  std::string name;
  /// Nothing is null.
  std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<std::string>> value;
};

/// What one message says, for people.
struct Reading {
  std::string type;  ///< SCHUNK's name of the command: "MOVE POS".
  std::string kind;  ///< "request", "answer", "failure" or "impulse".
  int module = 0;
  std::vector<Field> fields;
  std::optional<Utime> utime;       ///< Of its first frame.
  std::vector<std::size_t> frames;  ///< The numbers of its frames.
};

/// Listens to a bus on which others talk, and names everything that is said. Answers do not say in which unit they
/// count and what a state holds: the listener learns both from the talk (GET STATE's mask, the answer on the unit
/// system). Before it knows, it takes numbers for float32 and a state's for position, velocity, current in that order.
class Listener {
 public:
  struct Result {
    std::vector<Reading> readings;
    std::vector<BadFrames> bad;
  };

  /// Takes a frame of any identifier. `number` is the caller's name for it.
  Result add(const CanFrame& frame, std::size_t number, std::optional<Utime> utime);
  /// The recording ends.
  std::vector<BadFrames> end() { return assembler_.give_up("the recording ends within a fragmented message"); }

 private:
  struct Module {
    std::optional<UnitSystem> units;
    std::optional<std::uint8_t> mask;
  };

  Module& module_of(const Message& message) { return modules_[message.module]; }
  /// Both return why the message is no good, or nothing.
  std::string read_request(const Message& message, Reading& reading);
  std::string read_reply(const Message& message, Reading& reading);

  MessageAssembler assembler_;
  std::array<Module, 256> modules_;
};

}  // namespace scanway::schunk
