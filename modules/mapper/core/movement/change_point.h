#pragma once

#include <cstddef>
#include <vector>

#include "modules/mapper/core/registration/icp.h"

namespace scanway {

using registration::Matrix6;
using registration::Vector6;

/// Normal equations of a small motion x = [rotation vector, translation]: of what some measurements say of it.
struct MotionEvidence {
  Matrix6 information = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
  std::size_t count = 0;

  /// residual(x) = residual + J x, with so much information.
  void add(const Vector6& J, double residual, double weight);
  MotionEvidence& operator+=(const MotionEvidence& other);
};

/// The motion that evidence tells of, where it is small unless something says more.
struct Motion {
  Vector6 x = Vector6::Zero();
  Matrix6 covariance = Matrix6::Zero();
  double gain = 0.0;  ///< Twice the log-likelihood that it adds to standing still.
};
Motion most_likely(const MotionEvidence& evidence);

/// Before which slot of time a motion changed, and the motions on both sides.
struct ChangePoint {
  std::size_t slot = 0;  ///< 0: none was found.
  Vector6 before = Vector6::Zero(), after = Vector6::Zero();
  Matrix6 covariance = Matrix6::Zero();  ///< Of after - before.
};

/// Where the slots are told best by two motions. Each side must hold `least` measurements.
ChangePoint find_change(const std::vector<MotionEvidence>& slots, std::size_t least);

}  // namespace scanway
