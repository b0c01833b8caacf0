#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// The packets of the ERA-Mobi as the robot writes them.
namespace scanway::simulator {

using BaseBytes = std::vector<std::uint8_t>;

/// A whole packet: FA FB, length, payload, checksum.
BaseBytes base_packet(std::span<const std::uint8_t> payload);

/// The robot's motion as it counts it.
struct MotorCounts {
  bool moving = false;
  std::uint32_t x = 0, y = 0;  ///< 24 bits.
  std::int16_t heading = 0;    ///< 4096 a turn.
  std::int16_t left = 0, right = 0;
  std::uint8_t battery = 123;  ///< 0.1 V.
  bool left_stall = false, right_stall = false;
  std::int16_t control = 0;
};
BaseBytes motor_packet(const MotorCounts& counts);
BaseBytes configuration_packet(const std::string& name, const std::string& type, const std::string& subtype);

struct BaseRequest {
  std::uint8_t command = 0;
  int number = 0;      ///< Its argument, 0 without one.
  BaseBytes argument;  ///< The bytes of the argument, without its type.
};

/// Finds the commands in what the host sends; what is none is passed over.
class BaseRequests {
 public:
  void push(std::span<const std::uint8_t> bytes) { waiting_.insert(waiting_.end(), bytes.begin(), bytes.end()); }
  std::optional<BaseRequest> next();

 private:
  BaseBytes waiting_;
};

}  // namespace scanway::simulator
