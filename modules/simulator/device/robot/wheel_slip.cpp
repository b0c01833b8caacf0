#include "modules/simulator/device/robot/wheel_slip.h"

#include <algorithm>
#include <cmath>

#include "common/math/angle.h"
#include "common/math/repeatable.h"
#include "common/random/random.h"

namespace scanway::simulator {
namespace {

constexpr double kStretch_m = 0.1;
constexpr double kStretch = radians(10);
constexpr std::uint64_t kOfWay = 0x776179, kOfTurn = 0x7475726E;

}  // namespace

double WheelSlip::grip(std::int64_t stretch, std::uint64_t of) const {
  Random random(Random(seed_ ^ of).next() + static_cast<std::uint64_t>(stretch));
  return std::max(0.0, 1.0 - share_ * (0.5 + random.uniform()));
}

Pose WheelSlip::motion_between(const WheelMotion& from, const WheelMotion& to) {
  const double dx = (to.x_mm - from.x_mm) * 1e-3, dy = (to.y_mm - from.y_mm) * 1e-3, turn = to.heading - from.heading;
  const double c = repeatable::cos(from.heading), s = repeatable::sin(from.heading);
  driven_m_ += std::sqrt(dx * dx + dy * dy);
  turned_ += std::fabs(turn);
  const double way = grip(static_cast<std::int64_t>(driven_m_ / kStretch_m), kOfWay);
  Pose motion = Pose::Identity();
  motion.translation() = way * Eigen::Vector3d(c * dx + s * dy, c * dy - s * dx, 0.0);
  motion.linear() = rotation_about_z(turn * grip(static_cast<std::int64_t>(turned_ / kStretch), kOfTurn));
  return motion;
}

}  // namespace scanway::simulator
