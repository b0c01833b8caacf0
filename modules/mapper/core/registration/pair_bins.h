#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace scanway::registration {

constexpr int kAngleBins = 11;

/// The three angles of a pair of points with normals in its Darboux frame (Rusu 2009, equation 1), as bins of three
/// histograms that lie one behind the other: a byte each, the first one lowest.
using PairBins = std::uint32_t;
constexpr PairBins kNoBins = 0xFFFFFFFFu;  ///< One has no normal, or it lies along the line between them.

/// Points with their normals, by coordinate, so that pairs are computed in vectors. A point without a normal has zeros.
struct OrientedPoints {
  std::vector<float> x, y, z, nx, ny, nz;

  void resize(std::size_t count);
  void set(std::size_t k, const Eigen::Vector3f& point, const Eigen::Vector3f& normal) {
    x[k] = point.x(), y[k] = point.y(), z[k] = point.z();
    nx[k] = normal.x(), ny[k] = normal.y(), nz[k] = normal.z();
  }
};

/// Of a point with each of the first `count` others; `squared_distance` from it to each of them.
void find_pair_bins(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, const OrientedPoints& others,
                    const float* squared_distance, std::size_t count, PairBins* bins);

}  // namespace scanway::registration
