#include "modules/mapper/core/registration/matching.h"

#include <algorithm>
#include <limits>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/registration/lanes.h"

namespace scanway::registration {
namespace {

constexpr std::size_t kDims = kFpfhBins + 3;
constexpr std::size_t kVectors = 4;  // of scores that stay in registers, for each of two sources
constexpr std::size_t kStrip = kLanes * kVectors;
constexpr std::size_t kBlock = 128;        // sources of a block
constexpr float kNormalWeight = 60.0f;     // in percents of a histogram: opposite normals differ as unlike corners do
constexpr float kMinNormalCosine = 0.85f;  // 32 degrees: the tracker's worst heading and the normals' own error

/// Descriptors by dimension, in strips of targets: [strip][dimension][lane], padded with far-away ones.
struct Strips {
  std::vector<float> value;
  std::vector<float> half_norm;
  std::size_t count = 0;
};

using Descriptor = std::array<float, kDims>;

Descriptor extended(const Fpfh& fpfh, const Eigen::Vector3f& normal, float weight) {
  Descriptor d;
  std::copy(fpfh.begin(), fpfh.end(), d.begin());
  for (std::size_t k = 0; k < 3; ++k) d[kFpfhBins + k] = weight * normal[static_cast<int>(k)];
  return d;
}

float half_squared_norm(const Descriptor& d) {
  float sum = 0.0f;
  for (const float v : d) sum += v * v;
  return 0.5f * sum;
}

Strips make_strips(const std::vector<Descriptor>& descriptors) {
  Strips strips;
  strips.count = (descriptors.size() + kStrip - 1) / kStrip;
  strips.value.assign(strips.count * kStrip * kDims, 0.0f);
  strips.half_norm.assign(strips.count * kStrip, std::numeric_limits<float>::max());
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    float* strip = strips.value.data() + i / kStrip * kStrip * kDims;
    for (std::size_t d = 0; d < kDims; ++d) strip[d * kStrip + i % kStrip] = descriptors[i][d];
    strips.half_norm[i] = half_squared_norm(descriptors[i]);
  }
  return strips;
}

/// For each descriptor the nearest of the others that came by; of equals, the first.
struct Nearest {
  explicit Nearest(std::size_t count) : score(count, std::numeric_limits<float>::max()), index(count, 0) {}
  std::vector<float> score;
  std::vector<std::uint32_t> index;

  void offer(std::size_t i, float other_score, std::uint32_t other) {
    if (other_score < score[i]) score[i] = other_score, index[i] = other;
  }
};

/// Offers source `i` with its scores to the targets of a strip. Returns whether a score is below `limit`.
__attribute__((always_inline)) inline bool offer(const Lanes* score, std::uint32_t i, float limit, float* best,
                                                 std::uint32_t* index) {
  Indices any = {};
  for (std::size_t v = 0; v < kVectors; ++v) {
    Lanes& best_score = reinterpret_cast<Lanes*>(best)[v];
    Indices& best_index = reinterpret_cast<Indices*>(index)[v];
    const auto nearer = score[v] < best_score;
    any |= (Indices)(score[v] < limit);
    best_score = nearer ? score[v] : best_score;
    best_index = nearer ? Indices{} + i : best_index;
  }
  std::uint32_t found = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) found |= any[lane];
  return found != 0;
}

/// Scores of two sources and the targets of a strip: (|s|^2 + |t|^2) / 2 - s.t, half the squared distance.
__attribute__((always_inline)) inline void compute_scores(const float* const* source, const float* half_norm,
                                                          const float* strip, const float* strip_half_norm,
                                                          Lanes (&score)[2][kVectors]) {
  for (std::size_t v = 0; v < kVectors; ++v) {
    const Lanes norm = reinterpret_cast<const Lanes*>(strip_half_norm)[v];
    score[0][v] = norm + half_norm[0];
    score[1][v] = norm + half_norm[1];
  }
  for (std::size_t d = 0; d < kDims; ++d) {
    const Lanes* row = reinterpret_cast<const Lanes*>(strip + d * kStrip);
    for (std::size_t v = 0; v < kVectors; ++v) {
      score[0][v] -= source[0][d] * row[v];
      score[1][v] -= source[1][d] * row[v];
    }
  }
}

/// What a strip's kernel works on: sources [begin, end) against the targets from `first_target` on.
struct Comparison {
  const Descriptor* source;
  const float* half_norm;  ///< Of the sources.
  std::size_t begin, end;
  const float *strip, *strip_half_norm;
  std::size_t first_target;
};

__attribute__((target_clones("default", "avx2"))) void compare_strip(const Comparison& all, Nearest& to_target,
                                                                     Nearest& to_source) {
  float* best = to_source.score.data() + all.first_target;
  std::uint32_t* index = to_source.index.data() + all.first_target;
  for (std::size_t i = all.begin; i < all.end; i += 2) {
    const std::size_t pair[2] = {i, std::min(i + 1, all.end - 1)};
    const float* source[2] = {all.source[pair[0]].data(), all.source[pair[1]].data()};
    const float half_norm[2] = {all.half_norm[pair[0]], all.half_norm[pair[1]]};
    Lanes score[2][kVectors];
    compute_scores(source, half_norm, all.strip, all.strip_half_norm, score);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t s = pair[k];
      if (!offer(score[k], static_cast<std::uint32_t>(s), to_target.score[s], best, index)) continue;
      for (std::size_t t = 0; t < kStrip; ++t) {
        to_target.offer(s, score[k][t / kLanes][t % kLanes], static_cast<std::uint32_t>(all.first_target + t));
      }
    }
  }
}

/// For each descriptor of either side its nearest on the other; of equals, the lowest.
struct BothWays {
  Nearest to_target, to_source;
};

BothWays nearest_descriptors(const std::vector<Descriptor>& source, const std::vector<Descriptor>& target) {
  const Strips strips = make_strips(target);
  std::vector<float> half_norm(source.size());
  std::transform(source.begin(), source.end(), half_norm.begin(), half_squared_norm);
  BothWays nearest{Nearest(source.size()), Nearest(strips.count * kStrip)};
  std::vector<Nearest> columns((source.size() + kBlock - 1) / kBlock, nearest.to_source);
  for_blocks(source.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t block) {
    for (std::size_t strip = 0; strip < strips.count; ++strip) {
      const std::size_t first = strip * kStrip;
      compare_strip({source.data(), half_norm.data(), begin, end, strips.value.data() + first * kDims,
                     strips.half_norm.data() + first, first},
                    nearest.to_target, columns[block]);
    }
  });
  for (const Nearest& column : columns) {
    for (std::size_t j = 0; j < column.score.size(); ++j) nearest.to_source.offer(j, column.score[j], column.index[j]);
  }
  return nearest;
}

}  // namespace

std::vector<Match> match_keypoints(const Keypoints& source, const Keypoints& target,
                                   const std::optional<Eigen::Matrix3f>& R_target_source, bool mutual) {
  if (source.size() == 0 || target.size() == 0) return {};
  const float weight = R_target_source ? kNormalWeight : 0.0f;
  const Eigen::Matrix3f R = R_target_source.value_or(Eigen::Matrix3f::Identity());
  std::vector<Descriptor> s(source.size()), t(target.size());
  for (std::size_t i = 0; i < s.size(); ++i) s[i] = extended(source.descriptor[i], R * source.normal[i], weight);
  for (std::size_t i = 0; i < t.size(); ++i) t[i] = extended(target.descriptor[i], target.normal[i], weight);
  const auto [to_target, to_source] = nearest_descriptors(s, t);
  const auto agree = [&](std::uint32_t i, std::uint32_t j) {
    return !R_target_source || (R * source.normal[i]).dot(target.normal[j]) >= kMinNormalCosine;
  };
  std::vector<Match> matches;
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    const std::uint32_t j = to_target.index[i];
    if ((!mutual || to_source.index[j] == i) && agree(i, j)) matches.push_back({i, j});
  }
  for (std::uint32_t j = 0; j < t.size() && !mutual; ++j) {
    const std::uint32_t i = to_source.index[j];
    if (to_target.index[i] != j && agree(i, j)) matches.push_back({i, j});
  }
  return matches;
}

}  // namespace scanway::registration
