#pragma once

#include <cmath>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace scanway::test {

/// A robot as the protocol sheet describes it, with an encoder and a decoder of its own: nothing here comes from the
/// bridge. Times in microseconds.
class TestRobot {
 public:
  std::string subtype = "Rev H";
  int baud = 38400;
  bool powered = true;
  std::int64_t report_period = 50'000;

  /// What it sends when bytes come at `line_baud`.
  std::vector<std::uint8_t> receive(const std::vector<std::uint8_t>& bytes, int line_baud) {
    std::vector<std::uint8_t> out;
    if (!powered || line_baud != baud) return out;
    in_.insert(in_.end(), bytes.begin(), bytes.end());
    while (in_.size() >= 3 && in_.size() >= 3u + in_[2]) {
      const std::vector<std::uint8_t> payload(in_.begin() + 3, in_.begin() + 1 + in_[2]);
      in_.erase(in_.begin(), in_.begin() + 3 + in_[2]);
      obey(payload, out);
    }
    return out;
  }

  /// What it sends unasked by now.
  std::vector<std::uint8_t> run(std::int64_t now) {
    if (!powered || !open_ || now < next_) return {};
    next_ = now + report_period;
    const double seconds = static_cast<double>(report_period) * 1e-6;
    if (motors_on) {
      heading += turn_deg_s * 3.14159265358979 / 180 * seconds;
      x_mm += speed_mm_s * seconds * std::cos(heading);
      y_mm += speed_mm_s * seconds * std::sin(heading);
    }
    return packet(motor_payload());
  }

  /// The clock that it is told has been set.
  void report_now(std::int64_t now) { next_ = now; }

  void reboot() {
    open_ = motors_on = false;
    x_mm = y_mm = heading = 0;
    speed_mm_s = turn_deg_s = 0;
    in_.clear();
  }

  static std::vector<std::uint8_t> packet(const std::vector<std::uint8_t>& payload) {
    std::uint16_t sum = 0;
    for (std::size_t i = 0; i < payload.size(); i += 2) {
      if (i + 1 < payload.size()) {
        sum = static_cast<std::uint16_t>(sum + payload[i] * 256 + payload[i + 1]);
      } else {
        sum ^= payload[i];
      }
    }
    std::vector<std::uint8_t> bytes;
    for (const int byte : {0xFA, 0xFB, static_cast<int>(payload.size()) + 2})
      bytes.push_back(static_cast<std::uint8_t>(byte));
    for (const std::uint8_t byte : payload) bytes.push_back(byte);
    bytes.push_back(static_cast<std::uint8_t>(sum / 256));
    bytes.push_back(static_cast<std::uint8_t>(sum % 256));
    return bytes;
  }

  std::vector<int> commands;  ///< Numbers of the commands that came, in order.
  bool motors_on = false;
  int speed_mm_s = 0, turn_deg_s = 0;
  double x_mm = 0, y_mm = 0, heading = 0;
  bool stalled = false;

 private:
  void obey(const std::vector<std::uint8_t>& payload, std::vector<std::uint8_t>& out) {
    commands.push_back(payload[0]);
    int value = payload.size() == 4 ? payload[2] + 256 * payload[3] : 0;
    if (payload.size() == 4 && payload[1] == 0x1B) value = -value;
    switch (payload[0]) {
      case 18: {
        std::vector<std::uint8_t> reply(62, 0);
        reply[0] = 0x20;
        const std::string name = "era-1", type = "Erratic";
        std::copy(name.begin(), name.end(), reply.begin() + 2);
        std::copy(type.begin(), type.end(), reply.begin() + 22);
        std::copy(subtype.begin(), subtype.end(), reply.begin() + 42);
        const auto bytes = packet(reply);
        out.insert(out.end(), bytes.begin(), bytes.end());
        break;
      }
      case 1:
        open_ = true;
        break;
      case 2:
        open_ = false;
        break;
      case 4:
        motors_on = value == 1;
        break;
      case 11:
        speed_mm_s = value;
        break;
      case 21:
        turn_deg_s = value;
        break;
      case 29:
        speed_mm_s = turn_deg_s = 0;
        break;
      default:
        break;
    }
  }

  std::vector<std::uint8_t> motor_payload() const {
    const double scale = subtype == "Rev H" ? 0.930 : 0.780;
    const auto x = static_cast<std::uint32_t>(std::llround(x_mm / scale)),
               y = static_cast<std::uint32_t>(std::llround(y_mm / scale));
    const auto h = static_cast<std::int16_t>(std::llround(heading * 2048 / 3.14159265358979));
    const auto wheel = static_cast<std::int16_t>(std::llround(speed_mm_s / 1.20482));
    const auto lo = [](auto v) { return static_cast<std::uint8_t>(v & 0xFF); };
    const auto hi = [](auto v) { return static_cast<std::uint8_t>(v >> 8 & 0xFF); };
    const std::uint8_t type = speed_mm_s == 0 && turn_deg_s == 0 ? 0x82 : 0x83;
    return {type,      lo(x),       hi(x),     lo(x >> 16), lo(y),
            hi(y),     lo(y >> 16), lo(h),     hi(h),       lo(wheel),
            hi(wheel), lo(wheel),   hi(wheel), 123,         static_cast<std::uint8_t>(stalled),
            0,         0,           0};
  }

  std::vector<std::uint8_t> in_;
  bool open_ = false;
  std::int64_t next_ = 0;
};

}  // namespace scanway::test
