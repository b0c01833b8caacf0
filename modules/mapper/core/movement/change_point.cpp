#include "modules/mapper/core/movement/change_point.h"

#include <Eigen/LU>

namespace scanway {
namespace {

constexpr double kWidestTurn = 0.02, kWidestShift = 0.5;  // deviations before anything was seen: radians, metres

}  // namespace

Motion most_likely(const MotionEvidence& evidence) {
  Matrix6 information = evidence.information;
  information.diagonal().head<3>().array() += 1.0 / (kWidestTurn * kWidestTurn);
  information.diagonal().tail<3>().array() += 1.0 / (kWidestShift * kWidestShift);
  const Matrix6 covariance = information.inverse();
  const Vector6 x = -(covariance * evidence.gradient);
  return {x, covariance, -x.dot(evidence.gradient)};
}

void MotionEvidence::add(const Vector6& J, double residual, double weight) {
  information += weight * J * J.transpose();
  gradient += weight * residual * J;
  ++count;
}

MotionEvidence& MotionEvidence::operator+=(const MotionEvidence& other) {
  information += other.information;
  gradient += other.gradient;
  count += other.count;
  return *this;
}

ChangePoint find_change(const std::vector<MotionEvidence>& slots, std::size_t least) {
  std::vector<MotionEvidence> from(slots.size() + 1);  // Of all slots from here on.
  for (std::size_t i = slots.size(); i-- > 0;) (from[i] = slots[i]) += from[i + 1];
  ChangePoint best;
  MotionEvidence until;
  double most = 0.0;
  for (std::size_t slot = 1; slot < slots.size(); ++slot) {
    until += slots[slot - 1];
    if (until.count < least || from[slot].count < least) continue;
    const Motion before = most_likely(until), after = most_likely(from[slot]);
    if (before.gain + after.gain <= most) continue;
    most = before.gain + after.gain;
    best = {slot, before.x, after.x, before.covariance + after.covariance};
  }
  return best;
}

}  // namespace scanway
