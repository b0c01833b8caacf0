#include "modules/mapper/core/registration/pair_bins.h"

#include <cmath>

namespace scanway::registration {
namespace {

constexpr float kPi = 3.14159265358979f;

// What follows has choices in the place of branches, and sums in the order of Eigen's: it serves in vectors of any
// width.

/// atan2 to 2e-6: a minimax polynomial on [0, 1] and the octants' symmetry.
inline float atan2_approx(float y, float x) {
  const float ax = std::fabs(x), ay = std::fabs(y);
  const float high = ax > ay ? ax : ay, low = ax > ay ? ay : ax;
  const float t = low / (high > 0.0f ? high : 1.0f), s = t * t;
  float angle = 0.0028662257f;
  angle = angle * s - 0.0161657367f;
  angle = angle * s + 0.0429096138f;
  angle = angle * s - 0.0752896400f;
  angle = angle * s + 0.1065626393f;
  angle = angle * s - 0.1420889944f;
  angle = angle * s + 0.1999355085f;
  angle = angle * s - 0.3333314528f;
  angle = (angle * s + 1.0f) * t;
  angle = ay > ax ? kPi / 2 - angle : angle;
  angle = x < 0.0f ? kPi - angle : angle;
  return y < 0.0f ? -angle : angle;
}

/// Of a value from 0 to 1.
inline std::uint32_t bin_of(float unit) {
  const auto bin = static_cast<std::int32_t>(unit * kAngleBins);
  return static_cast<std::uint32_t>(bin < 0 ? 0 : (bin < kAngleBins ? bin : kAngleBins - 1));
}

inline float dot(float ax, float ay, float az, float bx, float by, float bz) { return ax * bx + (ay * by + az * bz); }

}  // namespace

void OrientedPoints::resize(std::size_t count) {
  for (std::vector<float>* column : {&x, &y, &z, &nx, &ny, &nz}) column->resize(count);
}

/// The frame stands on the point whose normal makes the smaller angle with the line between them, so both points of a
/// pair see the same.
__attribute__((target_clones("default", "avx2"))) void find_pair_bins(const Eigen::Vector3f& point,
                                                                      const Eigen::Vector3f& normal,
                                                                      const OrientedPoints& others,
                                                                      const float* squared_distance, std::size_t count,
                                                                      PairBins* __restrict bins) {
  const float px = point.x(), py = point.y(), pz = point.z();
  const float ax = normal.x(), ay = normal.y(), az = normal.z();
  const float *x = others.x.data(), *y = others.y.data(), *z = others.z.data();
  const float *nx = others.nx.data(), *ny = others.ny.data(), *nz = others.nz.data();
  for (std::size_t k = 0; k < count; ++k) {
    const float dx = x[k] - px, dy = y[k] - py, dz = z[k] - pz, d2 = squared_distance[k];
    const float bx = nx[k], by = ny[k], bz = nz[k];
    const float inverse = 1.0f / std::sqrt(d2 > 0.0f ? d2 : 1.0f);
    const float angle1 = dot(ax, ay, az, dx, dy, dz) * inverse, angle2 = dot(bx, by, bz, dx, dy, dz) * inverse;
    const bool swap = std::fabs(angle1) < std::fabs(angle2);
    const float ux = swap ? bx : ax, uy = swap ? by : ay, uz = swap ? bz : az;
    const float mx = swap ? ax : bx, my = swap ? ay : by, mz = swap ? az : bz;
    const float sign = swap ? -1.0f : 1.0f, phi = swap ? -angle2 : angle1;
    const float wx = sign * (dy * uz - dz * uy), wy = sign * (dz * ux - dx * uz), wz = sign * (dx * uy - dy * ux);
    const float w2 = dot(wx, wy, wz, wx, wy, wz);
    const bool defined = d2 > 0.0f && dot(bx, by, bz, bx, by, bz) > 0.5f && w2 > 1e-12f * d2;
    const float length = 1.0f / std::sqrt(defined ? w2 : 1.0f);
    const float vx = wx * length, vy = wy * length, vz = wz * length;
    const float theta = atan2_approx(dot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx, mx, my, mz),
                                     dot(ux, uy, uz, mx, my, mz));
    const std::uint32_t first = bin_of((theta + kPi) * (0.5f / kPi));
    const std::uint32_t second = bin_of((dot(vx, vy, vz, mx, my, mz) + 1.0f) * 0.5f) + kAngleBins;
    const std::uint32_t third = bin_of((phi + 1.0f) * 0.5f) + 2 * kAngleBins;
    bins[k] = defined ? first | second << 8 | third << 16 : kNoBins;
  }
}

}  // namespace scanway::registration
