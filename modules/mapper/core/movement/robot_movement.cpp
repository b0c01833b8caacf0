#include "modules/mapper/core/movement/robot_movement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "modules/mapper/core/movement/change_point.h"

namespace scanway {
namespace {

using registration::CellGrid;
using registration::Surfaces;

constexpr std::size_t kSlots = 60;
constexpr std::size_t kLeastMatches = 60;  // on either side of the movement
constexpr float kReach = 0.6f;             // metres between the centres of like surfaces
constexpr float kMinNormalCosine = 0.9f;
constexpr double kSigma = 0.015;      // metres, of a surface against its like
constexpr double kCorrelation = 6.0;  // neighbouring surfaces are wrong together
constexpr std::array<double, 4> kKernels{0.2, 0.1, 0.05, 0.03};

constexpr double kLeastShift = 0.02;   // metres
constexpr double kLeastTurn = 0.0035;  // radians, as the tracker's
constexpr double kDeviations = 5.0;

Pose moved_by(const Pose& T, const Vector6& x) {
  Pose moved = T;
  moved.linear() = exp_so3(x.head<3>()) * T.linear();
  moved.translation() += x.tail<3>();
  return moved;
}

/// A surface of the sweep, and when it was seen.
struct TimedSurface {
  std::size_t surface, slot;
};

class Search {
 public:
  Search(const DirectionTimes& times, const PreparedScan::Data& sweep, const PreparedScan::Data& target, const Pose& T)
      : sweep_(sweep), target_(target), T_(T) {
    for (std::size_t i = 0; i < sweep.surfaces.count(); ++i) {
      const auto time = times.at(sweep.surfaces.centre[i]);
      if (!time) continue;
      const auto slot = static_cast<std::size_t>(*time / times.duration_s() * static_cast<double>(kSlots));
      surfaces_.push_back({i, std::min(slot, kSlots - 1)});
    }
  }

  ChangePoint run() const {
    ChangePoint change;
    for (const double kernel : kKernels) change = find_change(evidence(change, kernel), kLeastMatches);
    return change;
  }

 private:
  /// Linearised where the last round saw the robot, said of its motion from T.
  std::vector<MotionEvidence> evidence(const ChangePoint& known, double kernel) const {
    std::vector<MotionEvidence> slots(kSlots);
    const Pose before = moved_by(T_, known.before), after = moved_by(T_, known.after);
    for (const TimedSurface& timed : surfaces_) {
      const bool is_before = timed.slot < known.slot;
      add(timed.surface, is_before ? before : after, is_before ? known.before : known.after, kernel, slots[timed.slot]);
    }
    return slots;
  }

  void add(std::size_t i, const Pose& T, const Vector6& x, double kernel, MotionEvidence& slot) const {
    const Eigen::Vector3f lever = T.linear().cast<float>() * sweep_.surfaces.centre[i];
    const Eigen::Vector3f point = lever + T.translation().cast<float>();
    const Eigen::Vector3f normal = T.linear().cast<float>() * sweep_.surfaces.normal[i];
    const Surfaces& surfaces = target_.surfaces;
    const std::vector<std::uint32_t>& original = target_.surface_grid.original();
    const CellGrid::Nearest nearest = target_.surface_grid.nearest(point, kReach, [&](std::uint32_t position) {
      return normal.dot(surfaces.normal[original[position]]) > kMinNormalCosine;
    });
    if (!nearest.found()) return;
    const std::uint32_t j = original[nearest.position];
    const Eigen::Vector3f both = (normal + surfaces.normal[j]).normalized();
    const double residual = both.dot(point - surfaces.centre[j]);
    const double root = kernel * kernel / (kernel * kernel + residual * residual);
    Vector6 J;
    J << lever.cross(both).cast<double>(), both.cast<double>();
    slot.add(J, residual - J.dot(x), root * root / (kCorrelation * kSigma * kSigma));
  }

  const PreparedScan::Data &sweep_, &target_;
  const Pose T_;  // Between the sensors' centres.
  std::vector<TimedSurface> surfaces_;
};

double sigma_along(const Eigen::Vector3d& v, const Eigen::Matrix3d& covariance) {
  const double square = v.squaredNorm();
  return square > 0.0 ? std::sqrt(v.dot(covariance * v) / square) : std::sqrt(covariance.trace() / 3.0);
}

}  // namespace

RobotMovement robot_movement(const DirectionTimes& times, const PreparedScan::Data& sweep,
                             const PreparedScan::Data& target, const Pose& T_target_sweep) {
  RobotMovement movement;
  if (!times.known()) return movement;
  const Pose T = Eigen::Translation3d(-target.origin) * T_target_sweep * Eigen::Translation3d(sweep.origin);
  const ChangePoint change = Search(times, sweep, target, T).run();
  if (change.slot == 0) return movement;
  movement.known = true;
  const Vector6 by = change.after - change.before;
  movement.turn_rad = by.head<3>().norm();
  movement.shift_m = by.tail<3>().norm();
  movement.turn_sigma_rad = sigma_along(by.head<3>(), change.covariance.topLeftCorner<3, 3>());
  movement.shift_sigma_m = sigma_along(by.tail<3>(), change.covariance.bottomRightCorner<3, 3>());
  movement.after_s = static_cast<double>(change.slot) / static_cast<double>(kSlots) * times.duration_s();
  movement.moved = movement.shift_m > std::max(kLeastShift, kDeviations * movement.shift_sigma_m) ||
                   movement.turn_rad > std::max(kLeastTurn, kDeviations * movement.turn_sigma_rad);
  return movement;
}

}  // namespace scanway
