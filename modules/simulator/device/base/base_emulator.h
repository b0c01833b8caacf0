#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "common/time/utime.h"
#include "modules/simulator/device/base/base_packet.h"

namespace scanway::simulator {

struct BaseEmulatorConfig {
  std::string name = "era-1", subtype = "Rev H";
  Utime report_period = 50'000;  ///< Of motor packets; the real one's is not known.
  Utime watchdog = 0;            ///< Stands when no command comes for this long; 0: never. Not known of the real one.
  double max_speed_mm_s = 2000.0, max_turn_rad_s = 12.0;
  double acceleration_mm_s2 = 1000.0, turn_acceleration_rad_s2 = 5.0;
};

/// Where the wheels have brought the robot: the frame's origin is where it was switched on.
struct WheelMotion {
  double x_mm = 0.0, y_mm = 0.0, heading = 0.0;  ///< heading: radians, to the left, not wrapped.
  double speed_mm_s = 0.0, turn_rate_rad_s = 0.0;
};

/// An ERA-Mobi as the host hears it: bytes in, bytes out, its own clock as an argument. It is silent until the host
/// opens it, and moves only while its motors are on.
class BaseEmulator {
 public:
  explicit BaseEmulator(const BaseEmulatorConfig& config = {}) : config_(config) {}

  /// Its answers.
  BaseBytes receive(std::span<const std::uint8_t> bytes, Utime now);
  /// What it sends unasked by now.
  BaseBytes tick(Utime now);

  const WheelMotion& motion() const { return motion_; }
  bool motors_on() const { return motors_on_; }
  /// What the host asks for.
  double wanted_mm_s() const { return motors_on_ ? wanted_mm_s_ : 0.0; }
  double wanted_rad_s() const { return motors_on_ ? wanted_rad_s_ : 0.0; }
  /// As when a wheel is blocked: it stands, and says so.
  void block(bool blocked) { blocked_ = blocked; }
  /// Switched off and on: it counts from zero, and waits for the host to open it.
  void reboot();

 private:
  void obey(const BaseRequest& request, BaseBytes& answers, Utime now);
  void advance(Utime now);
  void step(double seconds);
  void stand();
  BaseBytes report() const;

  BaseEmulatorConfig config_;
  BaseRequests requests_;
  WheelMotion motion_;
  double wanted_mm_s_ = 0.0, wanted_rad_s_ = 0.0;
  bool open_ = false, motors_on_ = false, blocked_ = false;
  Utime advanced_ = 0, commanded_ = 0, next_report_ = 0;
};

}  // namespace scanway::simulator
