#pragma once

#include <Eigen/Core>

namespace scanway::registration {

/// Eigenvalues in rising order, and their unit eigenvectors as columns.
struct Eigen3 {
  Eigen::Vector3d values;
  Eigen::Matrix3d vectors;
};

/// Of a symmetric 3x3 matrix, by cyclic Jacobi rotations: square roots only, so the bits are the same on every CPU
/// (Eigen's closed form calls acos and cos of the C library).
Eigen3 symmetric_eigen(const Eigen::Matrix3d& matrix);

}  // namespace scanway::registration
