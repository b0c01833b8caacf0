#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace scanway::tools {

/// What the base is told: metres and radians a second, positive ahead and to the left.
struct Motion {
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
};

struct FollowerLimits {
  double speed_m_s = 0.3;
  double lookahead_m = 0.35;
  double tolerance_m = 0.05;  ///< It has arrived when so little of the path is ahead.
  double off_path_m = 0.5;    ///< Farther from the path it is lost.
};

/// Drives a robot that can turn in place along a path: pure pursuit (Coulter, CMU-RI-TR-92-01, 1992) of a point of the
/// path a little ahead; a turn in place where that point is not ahead of the robot. All speeds are proportional to
/// `speed_m_s`, so the way driven does not depend on it.
class PathFollower {
 public:
  /// `path`: at least one point, metres.
  PathFollower(std::vector<Eigen::Vector2d> path, const FollowerLimits& limits);

  /// What to do at that place of the path's frame; nothing when it has arrived, or is lost. Calls come in the order of
  /// driving: what was passed is not driven again.
  std::optional<Motion> next(const Eigen::Vector2d& at, double heading);

  double off_path_m() const { return off_path_m_; }  ///< At the last call.
  bool lost() const { return off_path_m_ > limits_.off_path_m; }
  double length_m() const { return along_.back(); }
  double driven_m() const { return driven_m_; }  ///< Of the path.

 private:
  void advance(const Eigen::Vector2d& at);
  Eigen::Vector2d point_at(double along) const;

  std::vector<Eigen::Vector2d> path_;
  std::vector<double> along_;  // Of each point, from the path's start.
  FollowerLimits limits_;
  double driven_m_ = 0.0;
  double off_path_m_ = 0.0;
  bool turning_ = false;
};

}  // namespace scanway::tools
