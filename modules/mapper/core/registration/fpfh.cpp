#include "modules/mapper/core/registration/fpfh.h"

#include <algorithm>
#include <array>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/registration/lanes.h"
#include "modules/mapper/core/registration/pair_bins.h"

namespace scanway::registration {
namespace {

constexpr std::size_t kBlock = 256;

bool has_normal(const Eigen::Vector3f& normal) { return normal.squaredNorm() > 0.5f; }

/// The bins of a point's pairs with those neighbours that come after it.
void find_later_pairs(std::size_t i, const Points& points, const Points& normals, const Neighbourhoods& neighbourhoods,
                      OrientedPoints& others, std::vector<PairBins>& pairs) {
  const auto indices = neighbourhoods.of(i);
  const auto first = std::upper_bound(indices.begin(), indices.end(), static_cast<std::uint32_t>(i));
  const auto count = static_cast<std::size_t>(indices.end() - first);
  const std::size_t begin = neighbourhoods.begin[i + 1] - count;
  others.resize(std::max(count, others.x.size()));
  for (std::size_t k = 0; k < count; ++k) others.set(k, points[first[k]], normals[first[k]]);
  find_pair_bins(points[i], normals[i], others, neighbourhoods.squared_distance.data() + begin, count,
                 pairs.data() + begin);
}

/// The bins of every entry of the neighbourhoods. Each pair is computed once, by the point that comes first; lists are
/// in rising order, so a point's entries for those before it are filled in the order in which these come by.
std::vector<PairBins> all_pairs(const Points& points, const Points& normals, const Neighbourhoods& neighbourhoods) {
  std::vector<PairBins> pairs(neighbourhoods.index.size(), kNoBins);
  for_blocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    OrientedPoints others;
    for (std::size_t i = begin; i < end; ++i) {
      if (has_normal(normals[i])) find_later_pairs(i, points, normals, neighbourhoods, others, pairs);
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

/// A histogram that fills whole vectors; the rest stays zero.
constexpr std::size_t kVectors = 5, kPadded = kVectors * kLanes;
static_assert(kPadded >= kFpfhBins);
using PaddedFpfh = std::array<float, kPadded>;

/// The simplified histogram of one point: over the pairs of it and each of its neighbours.
PaddedFpfh simple_histogram(std::size_t i, const std::vector<PairBins>& pairs, const Neighbourhoods& neighbourhoods) {
  PaddedFpfh histogram{};
  const float share = 100.0f / static_cast<float>(std::max<std::size_t>(1, neighbourhoods.of(i).size()));
  for (std::uint32_t k = neighbourhoods.begin[i]; k < neighbourhoods.begin[i + 1]; ++k) {
    const PairBins bins = pairs[k];
    if (bins == kNoBins) continue;
    histogram[bins & 0xFF] += share;
    histogram[bins >> 8 & 0xFF] += share;
    histogram[bins >> 16] += share;
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

/// sum[b] of weight[k] * simple[index[k]][b].
__attribute__((target_clones("default", "avx2"))) void add_weighted(const PaddedFpfh* simple,
                                                                    const std::uint32_t* index, const float* weight,
                                                                    std::size_t count, PaddedFpfh& sum) {
  Lanes total[kVectors] = {};
  for (std::size_t k = 0; k < count; ++k) {
    const Lanes* other = reinterpret_cast<const Lanes*>(simple[index[k]].data());
    for (std::size_t v = 0; v < kVectors; ++v) total[v] += weight[k] * other[v];
  }
  for (std::size_t v = 0; v < kVectors; ++v) reinterpret_cast<Lanes*>(sum.data())[v] = total[v];
}

Fpfh weighted_histogram(std::size_t i, const std::vector<PaddedFpfh>& simple, const Neighbourhoods& neighbourhoods,
                        std::vector<float>& weight) {
  const auto indices = neighbourhoods.of(i);
  weight.resize(indices.size());
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const float d2 = neighbourhoods.squared_distance[neighbourhoods.begin[i] + k];
    weight[k] = d2 > 0.0f ? 1.0f / d2 : 0.0f;
  }
  PaddedFpfh sum;
  add_weighted(simple.data(), indices.data(), weight.data(), indices.size(), sum);
  Fpfh histogram;
  std::copy(sum.begin(), sum.begin() + kFpfhBins, histogram.begin());
  normalise_thirds(histogram);
  return histogram;
}

}  // namespace

std::vector<Fpfh> compute_fpfh(const Points& points, const Normals& normals, const Neighbourhoods& neighbourhoods) {
  std::vector<PaddedFpfh> simple(points.size());
  std::vector<Fpfh> result(points.size());
  const std::vector<PairBins> pairs = all_pairs(points, normals.normal, neighbourhoods);
  for_blocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) simple[i] = simple_histogram(i, pairs, neighbourhoods);
  });
  for_blocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    std::vector<float> weight;
    for (std::size_t i = begin; i < end; ++i) {
      if (has_normal(normals.normal[i])) result[i] = weighted_histogram(i, simple, neighbourhoods, weight);
    }
  });
  return result;
}

}  // namespace scanway::registration
