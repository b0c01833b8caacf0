#pragma once

#include <Eigen/Geometry>

#include "common/geometry/pose.h"

namespace scanway {

/// Messages carry quaternions as w, x, y, z (Eigen stores x, y, z, w). These two are the only places that know.
void put_quaternion(const Eigen::Quaterniond& R, double (&wxyz)[4]);
/// Throws BadMessage unless it is a unit quaternion within 1e-3; the result is normalised.
Eigen::Quaterniond get_quaternion(const double (&wxyz)[4]);

/// Transforms as 16 numbers, or the upper 12 of them, row by row.
void put_rows(const Pose& X, double (&rows)[16]);
/// Throws BadMessage unless they are finite and the last row is 0 0 0 1. The rotation is taken as it is.
Pose get_rows(const double (&rows)[16]);
Pose get_rows(const double (&rows)[12]);

}  // namespace scanway
