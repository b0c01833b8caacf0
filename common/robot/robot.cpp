#include "common/robot/robot.h"

#include <algorithm>
#include <limits>

namespace scanway {
namespace {

double distance_from_origin_to_edge(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d edge = b - a;
  const double along = std::clamp(-a.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (a + along * edge).norm();
}

Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double angle) { return exp_so3(axis * angle); }

}  // namespace

Pose Mount::pose() const {
  Pose X = Pose::Identity();
  X.linear() = rotation_about_z(roll_pitch_yaw.z()) * rotation_about(Eigen::Vector3d::UnitY(), roll_pitch_yaw.y()) *
               rotation_about(Eigen::Vector3d::UnitX(), roll_pitch_yaw.x());
  X.translation() = position_m;
  return X;
}

double Robot::inscribed_radius_m() const {
  double radius = std::numeric_limits<double>::infinity();
  const auto& corners = body.footprint;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    radius = std::min(radius, distance_from_origin_to_edge(corners[i], corners[(i + 1) % corners.size()]));
  }
  return radius;
}

double Robot::circumscribed_radius_m() const {
  double radius = 0.0;
  for (const Eigen::Vector2d& corner : body.footprint) radius = std::max(radius, corner.norm());
  return radius;
}

}  // namespace scanway
