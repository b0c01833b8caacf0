#include "modules/simulator/device/pan_tilt/motion_message.h"

#include <algorithm>
#include <array>
#include <utility>

namespace scanway::simulator {
namespace {

constexpr std::uint8_t kFirst = 0x84, kMiddle = 0x85, kLast = 0x86;
constexpr std::size_t kInOneFrame = 7, kInOneFragment = 6;

CanFrame frame_of(std::uint16_t id, std::span<const std::uint8_t> head, std::span<const std::uint8_t> content) {
  CanFrame frame;
  frame.id = id;
  frame.size = static_cast<std::uint8_t>(head.size() + content.size());
  std::copy(content.begin(), content.end(), std::copy(head.begin(), head.end(), frame.data.begin()));
  return frame;
}

}  // namespace

std::vector<CanFrame> frames_of(const MotionMessage& message, MotionClass who, std::uint8_t module) {
  const auto id = static_cast<std::uint16_t>(static_cast<std::uint16_t>(who) | module);
  std::span<const std::uint8_t> left(message);
  const auto length = [&] { return static_cast<std::uint8_t>(left.size()); };
  if (left.size() <= kInOneFrame) return {frame_of(id, std::array{length()}, left)};
  std::vector<CanFrame> frames;
  while (!left.empty()) {
    const std::size_t size = std::min(left.size(), kInOneFragment);
    const std::uint8_t code = frames.empty() ? kFirst : size == left.size() ? kLast : kMiddle;
    frames.push_back(frame_of(id, std::array{length(), code}, left.first(size)));
    left = left.subspan(size);
  }
  return frames;
}

std::optional<MotionMessage> MotionMessages::add(std::span<const std::uint8_t> frame) {
  if (frame.size() < 2) return MotionMessage();
  const std::uint8_t length = frame[0], code = frame[1];
  if (code < kFirst || code > kLast) {
    missing_ = 0;
    if (length == 0 || frame.size() < 1U + length) return MotionMessage();
    return MotionMessage(frame.begin() + 1, frame.begin() + 1 + length);
  }
  if (code == kFirst) {
    message_.clear();
    missing_ = length;
  }
  const auto content = frame.subspan(2, std::min(missing_, frame.size() - 2));
  message_.insert(message_.end(), content.begin(), content.end());
  missing_ -= content.size();
  if (code != kLast) return std::nullopt;
  const bool whole = missing_ == 0 && !message_.empty();
  missing_ = 0;
  return whole ? std::exchange(message_, {}) : MotionMessage();
}

void append_little_endian(MotionMessage& message, std::uint32_t value, int size) {
  for (int i = 0; i < size; ++i, value >>= 8) message.push_back(static_cast<std::uint8_t>(value & 0xFF));
}

std::uint32_t little_endian(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | bytes[i];
  return value;
}

}  // namespace scanway::simulator
