#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/bytes/can_frame.h"
#include "common/time/utime.h"
#include "modules/schunk_bridge/core/protocol.h"

namespace scanway::schunk {

/// Who speaks: the upper three bits of the CAN identifier. The lower eight are the module's id.
enum class Direction : std::uint8_t {
  error = 3,        ///< A module reports an error or a warning.
  to_module = 5,    ///< The master commands.
  from_module = 7,  ///< A module answers, or tells something unasked.
};

/// A message of the Motion Protocol, whole.
struct Message {
  Direction direction = Direction::to_module;
  std::uint8_t module = 0;
  Command command{};
  std::vector<std::uint8_t> parameters;  ///< At most 254 bytes.
  Utime utime = 0;                       ///< Of its first frame.
  std::vector<std::size_t> frames;       ///< The numbers of the frames that it came in.

  bool operator==(const Message& other) const {
    return direction == other.direction && module == other.module && command == other.command &&
           parameters == other.parameters;
  }
};

/// Whether the identifier is one of the Motion Protocol: class 3, 5 or 7 and a module from 1 to 255.
bool is_motion_protocol(std::uint16_t id);
std::uint16_t can_id(Direction direction, std::uint8_t module);

/// The frames of a message: one, or fragments if it is longer than 8 bytes.
std::vector<CanFrame> to_frames(const Message& message);

/// Frames that gave no message.
struct BadFrames {
  std::vector<std::size_t> frames;  ///< Their numbers.
  std::string reason;
};

/// Makes messages of frames. Fragments of several modules may interleave: they are put together an identifier.
class MessageAssembler {
 public:
  struct Result {
    std::optional<Message> message;
    std::vector<BadFrames> bad;
  };

  /// Takes a frame of the Motion Protocol. `number` is the caller's name for it. `now` dates messages, and ends the
  /// wait for a fragment that does not come.
  Result add(const CanFrame& frame, std::size_t number, Utime now);
  /// Gives up what is incomplete: frames were lost, or the recording ends.
  std::vector<BadFrames> give_up(const std::string& reason);

 private:
  struct Incomplete {
    Message message;
    std::size_t total = 0;            ///< Bytes of the message, its command included.
    std::vector<std::uint8_t> bytes;  ///< What is there of them.
  };

  void begin(const CanFrame& frame, std::size_t number, Utime now, Result& result);
  void append(const CanFrame& frame, std::size_t number, Utime now, Result& result);
  void finish(std::map<std::uint16_t, Incomplete>::iterator set, Result& result);

  std::map<std::uint16_t, Incomplete> incomplete_;
};

}  // namespace scanway::schunk
