#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace scanway {

/// Points in metres, in the frame that their owner states, and what the laser says of each.
struct PointCloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<float> intensity;  ///< As the device counts it; empty, or one a point.

  std::size_t size() const { return points.size(); }
  bool empty() const { return points.empty(); }
};

}  // namespace scanway
