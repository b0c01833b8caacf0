#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace scanway {

/// Points in metres, in the frame that their owner states, and what the laser and its surroundings say of each.
struct PointCloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<float> intensity;  ///< As the device counts it; empty, or one a point.
  /// Of the surface, a unit vector towards who saw it; (0, 0, 0) where it is not known. Empty, or one a point.
  std::vector<Eigen::Vector3f> normals;

  std::size_t size() const { return points.size(); }
  bool empty() const { return points.empty(); }
};

}  // namespace scanway
