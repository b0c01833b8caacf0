#include "modules/simulator/device/base/base_packet.h"

#include <algorithm>

namespace scanway::simulator {
namespace {

constexpr std::uint8_t kFirst = 0xFA, kSecond = 0xFB;
constexpr std::uint8_t kStanding = 0x82, kMoving = 0x83, kConfigurationReport = 0x20;
constexpr std::uint8_t kPositive = 0x3B, kNegative = 0x1B;

/// Over the payload in pairs, the first byte high; a byte that is left over goes into the low byte.
std::uint16_t checksum(std::span<const std::uint8_t> payload) {
  unsigned sum = 0;
  for (; payload.size() > 1; payload = payload.subspan(2)) sum += static_cast<unsigned>(payload[0] << 8 | payload[1]);
  if (!payload.empty()) sum ^= payload[0];
  return static_cast<std::uint16_t>(sum);
}

void append(BaseBytes& bytes, std::uint32_t value, int size) {
  for (int i = 0; i < size; ++i, value >>= 8) bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
}

void append(BaseBytes& bytes, std::int16_t value) { append(bytes, static_cast<std::uint16_t>(value), 2); }

BaseRequest request_of(std::span<const std::uint8_t> payload) {
  BaseRequest request;
  request.command = payload[0];
  if (payload.size() > 2) request.argument.assign(payload.begin() + 2, payload.end());
  if (payload.size() == 4) {
    const int magnitude = payload[2] | payload[3] << 8;
    if (payload[1] == kPositive) request.number = magnitude;
    if (payload[1] == kNegative) request.number = -magnitude;
  }
  return request;
}

}  // namespace

BaseBytes base_packet(std::span<const std::uint8_t> payload) {
  BaseBytes packet;
  packet.reserve(payload.size() + 5);
  for (const std::size_t byte : {std::size_t{kFirst}, std::size_t{kSecond}, payload.size() + 2}) {
    packet.push_back(static_cast<std::uint8_t>(byte));
  }
  packet.insert(packet.end(), payload.begin(), payload.end());
  const std::uint16_t sum = checksum(payload);
  packet.push_back(static_cast<std::uint8_t>(sum >> 8));
  packet.push_back(static_cast<std::uint8_t>(sum & 0xFF));
  return packet;
}

BaseBytes motor_packet(const MotorCounts& counts) {
  BaseBytes payload{counts.moving ? kMoving : kStanding};
  append(payload, counts.x, 3);
  append(payload, counts.y, 3);
  append(payload, counts.heading);
  append(payload, counts.left);
  append(payload, counts.right);
  payload.push_back(counts.battery);
  payload.push_back(counts.left_stall ? 1 : 0);
  payload.push_back(counts.right_stall ? 1 : 0);
  append(payload, counts.control);
  return base_packet(payload);
}

BaseBytes configuration_packet(const std::string& name, const std::string& type, const std::string& subtype) {
  constexpr std::size_t kSize = 62, kLongest = 19;
  BaseBytes payload(kSize, 0);
  payload[0] = kConfigurationReport;
  const auto put = [&](const std::string& text, std::ptrdiff_t at) {
    std::copy_n(text.begin(), std::min(text.size(), kLongest), payload.begin() + at);
  };
  put(name, 2);
  put(type, 22);
  put(subtype, 42);
  return base_packet(payload);
}

std::optional<BaseRequest> BaseRequests::next() {
  for (;; waiting_.erase(waiting_.begin())) {
    waiting_.erase(waiting_.begin(), std::find(waiting_.begin(), waiting_.end(), kFirst));
    if (waiting_.size() < 3) return std::nullopt;
    const std::size_t length = waiting_[2];
    if (waiting_[1] != kSecond || length < 3) continue;
    if (waiting_.size() < 3 + length) return std::nullopt;
    const auto payload = std::span(waiting_).subspan(3, length - 2);
    if (checksum(payload) != (waiting_[1 + length] << 8 | waiting_[2 + length])) continue;
    BaseRequest request = request_of(payload);
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(3 + length));
    return request;
  }
}

}  // namespace scanway::simulator
