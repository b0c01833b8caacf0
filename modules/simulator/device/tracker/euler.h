#pragma once

#include <array>

#include <Eigen/Core>

namespace scanway::simulator {

/// Roll, pitch and yaw in degrees, of R = Rz(yaw) Ry(pitch) Rx(roll).
std::array<double, 3> euler_deg(const Eigen::Matrix3d& R);

}  // namespace scanway::simulator
