#pragma once

#include <cstdint>

#include <Eigen/Geometry>

#include "common/geometry/pose.h"
#include "common/robot/robot.h"
#include "common/time/utime.h"

namespace scanway::simulator {

/// What an orientation tracker says while the robot stands.
struct TrackerReading {
  Eigen::Quaterniond R_world_base;
  Eigen::Vector3d gyro = Eigen::Vector3d::Zero();   ///< rad/s
  Eigen::Vector3d accel = Eigen::Vector3d::Zero();  ///< m/s^2: the ground's push, up.
};

/// The tracker of one sweep: off by a heading and a tilt that stay the same as long as the robot stands, and by a
/// little noise that does not. Heading errors end at two of the robot file's sigmas, tilt errors at three.
class Tracker {
 public:
  Tracker(const Robot::Tracker& model, const Pose& X_world_base, std::uint64_t seed);

  /// The reading number `index`; the same index gives the same reading.
  TrackerReading read(int index) const;
  /// Without the noise: what a long mean gives.
  Eigen::Quaterniond mean() const;

 private:
  Eigen::Matrix3d R_measured_;
  std::uint64_t seed_;
};

}  // namespace scanway::simulator
