#include "modules/simulator/core/tracker.h"

#include <algorithm>

#include "common/math/angle.h"
#include "modules/simulator/core/laser/beam_random.h"

namespace scanway::simulator {
namespace {

constexpr double kNoise = radians(0.02L);  // Of each reading's orientation, about each axis.
constexpr double kGyroNoise_rad_s = 0.002;
constexpr double kAccelNoise_m_s2 = 0.02;
constexpr double kGravity_m_s2 = 9.81;
constexpr int kTrackerLine = -2;  // Its random numbers are no beam's.

Eigen::Vector3d normals(Random& random) {
  const double x = random.normal(), y = random.normal();
  return {x, y, random.normal()};
}

}  // namespace

Tracker::Tracker(const Robot::Tracker& model, const Pose& X_world_base, std::uint64_t seed) : seed_(seed) {
  Random random(seed ^ 0x7261636B);
  const auto error = [&](double sigma, double most) { return sigma * std::clamp(random.normal(), -most, most); };
  const double heading = error(model.heading_sigma, 2.0), roll = error(model.tilt_sigma, 3.0);
  const double pitch = error(model.tilt_sigma, 3.0);
  R_measured_ = rotation_about_z(heading) * exp_so3({roll, pitch, 0.0}) * X_world_base.linear();
}

TrackerReading Tracker::read(int index) const {
  Random random = beam_random(seed_, kTrackerLine, index);
  TrackerReading reading;
  const Eigen::Matrix3d R = R_measured_ * exp_so3(kNoise * normals(random));
  reading.R_world_base = Eigen::Quaterniond(R).normalized();
  reading.gyro = kGyroNoise_rad_s * normals(random);
  reading.accel = R.transpose() * Eigen::Vector3d(0, 0, kGravity_m_s2) + kAccelNoise_m_s2 * normals(random);
  return reading;
}

Eigen::Quaterniond Tracker::mean() const { return Eigen::Quaterniond(R_measured_).normalized(); }

}  // namespace scanway::simulator
