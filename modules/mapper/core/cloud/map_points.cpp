#include "modules/mapper/core/cloud/map_points.h"

namespace scanway {

Eigen::Vector3d transform_in_order(const Pose& X, const Eigen::Vector3d& p) {
  Eigen::Vector3d q;
  for (int i = 0; i < 3; ++i) q[i] = ((X(i, 0) * p.x() + X(i, 1) * p.y()) + X(i, 2) * p.z()) + X(i, 3);
  return q;
}

MapPoints points_in_map(const Sweep& sweep, const Pose& X_map_sweep, double min_range_m, double max_range_m) {
  MapPoints result;
  const bool with_intensity = !sweep.cloud.intensity.empty();
  result.origin = transform_in_order(X_map_sweep, sweep.origin);
  result.points.reserve(sweep.cloud.size());
  if (with_intensity) result.intensity.reserve(sweep.cloud.size());
  for (std::size_t i = 0; i < sweep.cloud.size(); ++i) {
    const Eigen::Vector3d p = sweep.cloud.points[i].cast<double>();
    const double range = (p - sweep.origin).norm();
    if (!(range >= min_range_m && range <= max_range_m)) continue;  // NaN compares false and goes, too
    result.points.push_back(transform_in_order(X_map_sweep, p).cast<float>());
    if (with_intensity) result.intensity.push_back(sweep.cloud.intensity[i]);
  }
  return result;
}

}  // namespace scanway
