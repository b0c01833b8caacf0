#include "modules/mapper/core/registration/fpfh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "common/parallel/blocks.h"

namespace scanway::registration {
namespace {

constexpr int kAngleBins = kFpfhBins / 3;
constexpr std::size_t kBlock = 256;
constexpr float kPi = 3.14159265358979f;

/// atan2 to 2e-6: a minimax polynomial on [0, 1] and the octants' symmetry.
float atan2_approx(float y, float x) {
  const float ax = std::fabs(x), ay = std::fabs(y);
  const float high = std::max(ax, ay);
  if (high == 0.0f) return 0.0f;
  const float t = std::min(ax, ay) / high, s = t * t;
  float angle = 0.0028662257f;
  angle = angle * s - 0.0161657367f;
  angle = angle * s + 0.0429096138f;
  angle = angle * s - 0.0752896400f;
  angle = angle * s + 0.1065626393f;
  angle = angle * s - 0.1420889944f;
  angle = angle * s + 0.1999355085f;
  angle = angle * s - 0.3333314528f;
  angle = (angle * s + 1.0f) * t;
  if (ay > ax) angle = kPi / 2 - angle;
  if (x < 0.0f) angle = kPi - angle;
  return y < 0.0f ? -angle : angle;
}

int bin_of(float unit) { return std::clamp(static_cast<int>(unit * kAngleBins), 0, kAngleBins - 1); }

/// A pair's bins of the three histograms.
struct PairBins {
  std::array<std::uint8_t, 3> bin{};
  bool defined = false;
};

/// The three angles of a pair in its Darboux frame (Rusu 2009, equation 1), as bins of the histogram. The frame stands
/// on the point whose normal makes the smaller angle with the line between them, so both points of a pair see the same.
PairBins pair_bins(const Eigen::Vector3f& d, float d2, const Eigen::Vector3f& n1, const Eigen::Vector3f& n2) {
  const float inverse = 1.0f / std::sqrt(d2);
  const float angle1 = n1.dot(d) * inverse, angle2 = n2.dot(d) * inverse;
  const bool swap = std::fabs(angle1) < std::fabs(angle2);
  const Eigen::Vector3f& u = swap ? n2 : n1;
  const Eigen::Vector3f& n = swap ? n1 : n2;
  const float sign = swap ? -1.0f : 1.0f;
  const float phi = swap ? -angle2 : angle1;
  Eigen::Vector3f v = sign * d.cross(u);
  const float v2 = v.squaredNorm();
  if (!(v2 > 1e-12f * d2)) return {};
  v *= 1.0f / std::sqrt(v2);
  const float theta = atan2_approx(u.cross(v).dot(n), u.dot(n));
  const auto bin = [](int third, float unit) { return static_cast<std::uint8_t>(third * kAngleBins + bin_of(unit)); };
  return {{bin(0, (theta + kPi) * (0.5f / kPi)), bin(1, (v.dot(n) + 1.0f) * 0.5f), bin(2, (phi + 1.0f) * 0.5f)}, true};
}

bool has_normal(const Eigen::Vector3f& normal) { return normal.squaredNorm() > 0.5f; }

/// The bins of every entry of the neighbourhoods. Each pair is computed once, by the point that comes first; lists are
/// in rising order, so a point's entries for those before it are filled in the order in which these come by.
std::vector<PairBins> all_pairs(const Points& points, const Points& normals, const Neighbourhoods& neighbourhoods) {
  std::vector<PairBins> pairs(neighbourhoods.index.size());
  for_blocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!has_normal(normals[i])) continue;
      for (std::uint32_t k = neighbourhoods.begin[i]; k < neighbourhoods.begin[i + 1]; ++k) {
        const std::uint32_t j = neighbourhoods.index[k];
        const float d2 = neighbourhoods.squared_distance[k];
        if (j < i || !has_normal(normals[j]) || !(d2 > 0.0f)) continue;
        pairs[k] = pair_bins(points[j] - points[i], d2, normals[i], normals[j]);
      }
    }
  });
  std::vector<std::uint32_t> next(neighbourhoods.begin.begin(), neighbourhoods.begin.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::uint32_t k = neighbourhoods.begin[i]; k < neighbourhoods.begin[i + 1]; ++k) {
      const std::uint32_t j = neighbourhoods.index[k];
      if (j > i) pairs[next[j]++] = pairs[k];
    }
  }
  return pairs;
}

/// The simplified histogram of one point: over the pairs of it and each of its neighbours.
Fpfh simple_histogram(std::size_t i, const std::vector<PairBins>& pairs, const Neighbourhoods& neighbourhoods) {
  Fpfh histogram{};
  const float share = 100.0f / static_cast<float>(std::max<std::size_t>(1, neighbourhoods.of(i).size()));
  for (std::uint32_t k = neighbourhoods.begin[i]; k < neighbourhoods.begin[i + 1]; ++k) {
    if (!pairs[k].defined) continue;
    for (const std::uint8_t bin : pairs[k].bin) histogram[bin] += share;
  }
  return histogram;
}

void normalise_thirds(Fpfh& histogram) {
  for (std::size_t third = 0; third < 3; ++third) {
    float sum = 0.0f;
    for (std::size_t b = 0; b < kAngleBins; ++b) sum += histogram[third * kAngleBins + b];
    if (!(sum > 0.0f)) continue;
    for (std::size_t b = 0; b < kAngleBins; ++b) histogram[third * kAngleBins + b] *= 100.0f / sum;
  }
}

Fpfh weighted_histogram(std::size_t i, const std::vector<Fpfh>& simple, const Neighbourhoods& neighbourhoods) {
  Fpfh histogram{};
  for (std::uint32_t k = neighbourhoods.begin[i]; k < neighbourhoods.begin[i + 1]; ++k) {
    if (!(neighbourhoods.squared_distance[k] > 0.0f)) continue;
    const float weight = 1.0f / neighbourhoods.squared_distance[k];
    const Fpfh& other = simple[neighbourhoods.index[k]];
    for (std::size_t b = 0; b < kFpfhBins; ++b) histogram[b] += weight * other[b];
  }
  normalise_thirds(histogram);
  return histogram;
}

}  // namespace

std::vector<Fpfh> compute_fpfh(const Points& points, const Normals& normals, const Neighbourhoods& neighbourhoods) {
  std::vector<Fpfh> simple(points.size()), result(points.size());
  const std::vector<PairBins> pairs = all_pairs(points, normals.normal, neighbourhoods);
  for_blocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      simple[i] = simple_histogram(i, pairs, neighbourhoods);
    }
  });
  for_blocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      if (has_normal(normals.normal[i])) result[i] = weighted_histogram(i, simple, neighbourhoods);
    }
  });
  return result;
}

}  // namespace scanway::registration
