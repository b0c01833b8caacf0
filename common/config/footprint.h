#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace scanway {

/// What is wrong with a footprint, in words for people; empty if nothing is. A footprint is a simple polygon of 3 to
/// 256 corners (metres, in `base`), counter-clockwise, with the robot's centre (0, 0) inside.
std::string footprint_problem(const std::vector<Eigen::Vector2d>& corners);

}  // namespace scanway
