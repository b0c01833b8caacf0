#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/bytes/can_frame.h"

/// The SCHUNK Motion Protocol as a module speaks it (SCHUNK Motion manual v1.41).
namespace scanway::simulator {

/// A command and what follows it, 1 to 255 bytes; a long one takes several frames.
using MotionMessage = std::vector<std::uint8_t>;

/// Who says it: the class of the frame's identifier.
enum class MotionClass : std::uint16_t { error = 0x300, to_module = 0x500, from_module = 0x700 };

std::vector<CanFrame> frames_of(const MotionMessage& message, MotionClass who, std::uint8_t module);

/// Puts a module's messages together from its frames.
class MotionMessages {
 public:
  /// The message that this frame completes; an empty one where the frame is wrong.
  std::optional<MotionMessage> add(std::span<const std::uint8_t> frame);

 private:
  MotionMessage message_;
  std::size_t missing_ = 0;
};

/// Numbers as modules write them, the least significant byte first.
void append_little_endian(MotionMessage& message, std::uint32_t value, int size);
std::uint32_t little_endian(std::span<const std::uint8_t> bytes);

}  // namespace scanway::simulator
