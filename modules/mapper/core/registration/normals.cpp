#include "modules/mapper/core/registration/normals.h"

#include "common/parallel/blocks.h"
#include "modules/mapper/core/registration/eigen3.h"

namespace scanway::registration {
namespace {

/// Sums about one point, in which single precision loses nothing that matters.
struct Moments {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  int count = 1;

  void add(const Eigen::Vector3f& d) {
    sum += d;
    xx += d.x() * d.x(), xy += d.x() * d.y(), xz += d.x() * d.z();
    yy += d.y() * d.y(), yz += d.y() * d.z(), zz += d.z() * d.z();
    ++count;
  }
  Eigen::Matrix3d covariance() const {
    Eigen::Matrix3d C;
    C << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    const Eigen::Vector3d mean = sum.cast<double>() / count;
    return C / count - mean * mean.transpose();
  }
};

}  // namespace

Normals estimate_normals(const Points& points, const Neighbourhoods& neighbourhoods, float radius_m) {
  Normals result{Points(points.size(), Eigen::Vector3f::Zero()), std::vector<float>(points.size(), 0.0f)};
  const float limit = radius_m * radius_m;
  for_blocks(points.size(), 512, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      Moments moments;
      for (std::uint32_t k = neighbourhoods.begin[i]; k < neighbourhoods.begin[i + 1]; ++k) {
        if (neighbourhoods.squared_distance[k] <= limit) moments.add(points[neighbourhoods.index[k]] - points[i]);
      }
      if (moments.count < 3) continue;
      const Eigen3 eigen = symmetric_eigen(moments.covariance());
      if (!(eigen.values[1] > 1e-4 * eigen.values[2])) continue;
      const Eigen::Vector3f normal = eigen.vectors.col(0).cast<float>();
      result.normal[i] = normal.dot(points[i]) > 0 ? Eigen::Vector3f(-normal) : normal;
      result.curvature[i] = static_cast<float>(std::max(0.0, eigen.values[0]) / eigen.values.sum());
    }
  });
  return result;
}

}  // namespace scanway::registration
