#include "modules/tools/drive/path_follower.h"

#include <algorithm>
#include <cmath>

#include "common/math/angle.h"

namespace scanway::tools {
namespace {

using Eigen::Vector2d;

/// A turn in place begins beyond the first and ends within the second.
constexpr double kTurnFrom = radians(40), kTurnTo = radians(8);
constexpr double kTurnRadius_m = 0.25;     // In place it turns as if driving at full speed on a circle of this radius,
constexpr double kFullTurn = radians(60);  // and slower when less than this is left to turn.
constexpr double kSlowest = 0.2;           // Of the speed, towards the end.
constexpr double kAhead_m = 1.0;           // How far the next place on the path is looked for.

}  // namespace

PathFollower::PathFollower(std::vector<Vector2d> path, const FollowerLimits& limits)
    : path_(std::move(path)), along_{0.0}, limits_(limits) {
  for (std::size_t i = 1; i < path_.size(); ++i) along_.push_back(along_.back() + (path_[i] - path_[i - 1]).norm());
}

Vector2d PathFollower::point_at(double along) const {
  const auto behind = std::lower_bound(along_.begin(), along_.end(), along);
  if (behind == along_.end()) return path_.back();
  if (behind == along_.begin()) return path_.front();
  const auto i = static_cast<std::size_t>(behind - along_.begin());
  const double share = (along - along_[i - 1]) / (along_[i] - along_[i - 1]);
  return path_[i - 1] + share * (path_[i] - path_[i - 1]);
}

/// To the nearest point of the path that is not behind what was driven.
void PathFollower::advance(const Vector2d& at) {
  const double from = driven_m_, to = std::min(length_m(), driven_m_ + kAhead_m);
  off_path_m_ = (point_at(from) - at).norm();
  const auto consider = [&](double along) {
    const double distance = (point_at(along) - at).norm();
    if (distance >= off_path_m_) return;
    off_path_m_ = distance;
    driven_m_ = along;
  };
  for (double along = from; along < to; along += 0.01) consider(along);
  consider(to);
}

std::optional<Motion> PathFollower::next(const Vector2d& at, double heading) {
  advance(at);
  const double left_m = length_m() - driven_m_;
  if (lost() || left_m <= limits_.tolerance_m) return std::nullopt;
  const Vector2d ahead = point_at(driven_m_ + limits_.lookahead_m) - at;
  const double off = std::remainder(std::atan2(ahead.y(), ahead.x()) - heading, 2 * radians(180));
  turning_ = std::fabs(off) > (turning_ ? kTurnTo : kTurnFrom);
  if (turning_) {
    const double full = limits_.speed_m_s / kTurnRadius_m;
    return Motion{0.0, std::clamp(off / kFullTurn, -1.0, 1.0) * full};
  }
  const double speed = limits_.speed_m_s * std::clamp(left_m / limits_.lookahead_m, kSlowest, 1.0);
  return Motion{speed, 2.0 * speed * std::sin(off) / std::max(ahead.norm(), limits_.tolerance_m)};
}

}  // namespace scanway::tools
