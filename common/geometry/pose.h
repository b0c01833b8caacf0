#pragma once

#include <Eigen/Geometry>

namespace scanway {

/// A rigid transform. `X_AB` is the pose of frame B in frame A: p_A = X_AB * p_B, and X_AC = X_AB * X_BC.
/// In registration the same is written `T_target_source`.
using Pose = Eigen::Isometry3d;

/// Angle of the rotation R, radians in [0, pi]. Exact for small angles too (by atan2 of sine and cosine).
double rotation_angle(const Eigen::Matrix3d& R);

/// Rotation by `angle` radians about z: heading, counter-clockwise seen from above.
Eigen::Matrix3d rotation_about_z(double angle);

/// Heading of R: the angle about z, radians in (-pi, pi], of the horizontal part of its x axis.
double heading_of(const Eigen::Matrix3d& R);

/// The rotation whose rotation vector (axis times angle, radians) is `w`.
Eigen::Matrix3d exp_so3(const Eigen::Vector3d& w);

/// The rotation vector of R (axis times angle, radians, angle in [0, pi]).
Eigen::Vector3d log_so3(const Eigen::Matrix3d& R);

/// The rotation (determinant 1) nearest to the 3x3 matrix M in the sum of squares, by SVD (Umeyama, PAMI 13(4), 1991).
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M);

}  // namespace scanway
