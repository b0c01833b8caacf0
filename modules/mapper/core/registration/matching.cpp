#include "modules/mapper/core/registration/matching.h"

#include <algorithm>
#include <limits>

#include "common/parallel/blocks.h"

namespace scanway::registration {
namespace {

constexpr std::size_t kDims = kFpfhBins + 3;
constexpr std::size_t kLanes = 8;    // of a vector
constexpr std::size_t kVectors = 4;  // scores that stay in registers
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

typedef float Lanes __attribute__((vector_size(kLanes * sizeof(float)), aligned(sizeof(float))));

/// score[lane] = (|s|^2 + |t|^2) / 2 - s.t, half the squared distance. Lanes are independent, so every width of vector
/// instructions gives the same bits.
__attribute__((target_clones("default", "avx2"))) void strip_scores(const float* source, float source_half_norm,
                                                                    const float* strip, const float* half_norm,
                                                                    float* score) {
  Lanes sum[kVectors];
  for (std::size_t v = 0; v < kVectors; ++v) {
    sum[v] = reinterpret_cast<const Lanes*>(half_norm)[v] + source_half_norm;
  }
  for (std::size_t d = 0; d < kDims; ++d) {
    const Lanes* row = reinterpret_cast<const Lanes*>(strip + d * kStrip);
    for (std::size_t v = 0; v < kVectors; ++v) sum[v] -= source[d] * row[v];
  }
  for (std::size_t v = 0; v < kVectors; ++v) reinterpret_cast<Lanes*>(score)[v] = sum[v];
}

std::size_t lowest(const float* score) {
  std::size_t best = 0;
  for (std::size_t lane = 1; lane < kStrip; ++lane) {
    if (score[lane] < score[best]) best = lane;
  }
  return best;
}

struct Best {
  float score = std::numeric_limits<float>::max();
  std::uint32_t index = 0;

  void offer(float other_score, std::size_t other) {
    if (other_score < score) *this = {other_score, static_cast<std::uint32_t>(other)};
  }
};

/// For each descriptor of either side its nearest on the other; of equals, the lowest.
struct BothWays {
  std::vector<Best> to_target, to_source;
};

/// The sources [begin, end) against all targets.
void compare_block(const std::vector<Descriptor>& source, std::size_t begin, std::size_t end, const Strips& strips,
                   std::vector<Best>& to_target, std::vector<Best>& to_source) {
  alignas(32) std::array<float, kStrip> score;
  for (std::size_t strip = 0; strip < strips.count; ++strip) {
    Best* column = to_source.data() + strip * kStrip;
    for (std::size_t i = begin; i < end; ++i) {
      strip_scores(source[i].data(), half_squared_norm(source[i]), strips.value.data() + strip * kStrip * kDims,
                   strips.half_norm.data() + strip * kStrip, score.data());
      const std::size_t lane = lowest(score.data());
      to_target[i].offer(score[lane], strip * kStrip + lane);
      for (std::size_t l = 0; l < kStrip; ++l) column[l].offer(score[l], i);
    }
  }
}

BothWays nearest_descriptors(const std::vector<Descriptor>& source, const std::vector<Descriptor>& target) {
  const Strips strips = make_strips(target);
  BothWays nearest{std::vector<Best>(source.size()), std::vector<Best>(strips.count * kStrip)};
  std::vector<std::vector<Best>> columns((source.size() + kBlock - 1) / kBlock, nearest.to_source);
  for_blocks(source.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t block) {
    compare_block(source, begin, end, strips, nearest.to_target, columns[block]);
  });
  for (const std::vector<Best>& column : columns) {
    for (std::size_t j = 0; j < column.size(); ++j) nearest.to_source[j].offer(column[j].score, column[j].index);
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
    const std::uint32_t j = to_target[i].index;
    if ((!mutual || to_source[j].index == i) && agree(i, j)) matches.push_back({i, j});
  }
  for (std::uint32_t j = 0; j < t.size() && !mutual; ++j) {
    const std::uint32_t i = to_source[j].index;
    if (to_target[i].index != j && agree(i, j)) matches.push_back({i, j});
  }
  return matches;
}

}  // namespace scanway::registration
