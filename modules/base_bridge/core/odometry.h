#pragma once

#include <cstdint>
#include <optional>

#include "common/time/utime.h"
#include "modules/base_bridge/core/report.h"

namespace scanway::erratic {

/// Where the robot is, by its wheels. The frame's origin is the robot at its first report, its x axis the robot's
/// forward direction when it was switched on.
struct WheelPose {
  Utime utime = 0;
  double x_m = 0, y_m = 0;
  double heading = 0;          ///< Radians in (-pi, pi], to the left.
  double speed_m_s = 0;        ///< Forward.
  double turn_rate_rad_s = 0;  ///< To the left.
};

/// Adds up the position that the robot counts, whose counters wrap every 3 m or so, and carries it on when the robot
/// has begun to count anew. Counts are summed and converted once, so that nothing is lost to rounding.
class Odometry {
 public:
  explicit Odometry(double metres_per_count = 0.780e-3) : metres_per_count_(metres_per_count) {}

  /// What became of a report.
  enum class Step : std::uint8_t {
    first,  ///< It is the beginning.
    added,
    dropped,    ///< It is further than the robot can have gone; it does not count, the next one counts from here.
    continued,  ///< After a gap in which the counters may have wrapped: what was driven meanwhile is not known.
    restarted,  ///< After a gap in which the robot has begun to count anew.
  };
  Step add(const MotorReport& report, Utime now);

  /// The robot was away for a moment, and may have been switched off: when it says that it stands where it began, it
  /// has begun to count anew, however short the gap was.
  void was_away() { was_away_ = true; }

  /// Takes effect for what is driven from now on.
  void set_metres_per_count(double metres);

  const WheelPose& pose() const { return pose_; }

 private:
  struct Last {
    std::uint16_t x_counts = 0, y_counts = 0;
    Utime utime = 0;
    bool at_zero = false;
  };

  Step anchor(const MotorReport& report);
  void update(const MotorReport& report, Utime now);

  double metres_per_count_;
  std::optional<Last> last_;
  bool begun_ = false, was_away_ = false;
  std::int64_t x_sum_ = 0, y_sum_ = 0;      // Counts since the anchor.
  double anchor_x_m_ = 0, anchor_y_m_ = 0;  // Where the robot was then.
  double turn_ = 0;                         // From the robot's frame to ours, radians.
  WheelPose pose_;
};

}  // namespace scanway::erratic
