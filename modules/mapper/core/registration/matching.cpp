#include "modules/mapper/core/registration/matching.h"

#include <algorithm>
#include <limits>

#include "common/parallel/blocks.h"

namespace scanway::registration {
namespace {

constexpr std::size_t kDims = kFpfhBins + 3;
constexpr std::size_t kStrip = 64;         // targets of a strip, whose partial distances stay in the first-level cache
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

/// score[lane] = |t|^2 / 2 - s.t, which orders like the distance. Lanes are independent, so every width of vector
/// instructions gives the same bits.
__attribute__((target_clones("default", "avx2"))) void strip_scores(const float* source, const float* strip,
                                                                    const float* half_norm, float* score) {
  for (std::size_t lane = 0; lane < kStrip; ++lane) score[lane] = half_norm[lane];
  for (std::size_t d = 0; d < kDims; ++d) {
    const float s = source[d];
    for (std::size_t lane = 0; lane < kStrip; ++lane) score[lane] -= s * strip[d * kStrip + lane];
  }
}

std::size_t lowest(const float* score) {
  std::size_t best = 0;
  for (std::size_t lane = 1; lane < kStrip; ++lane) {
    if (score[lane] < score[best]) best = lane;
  }
  return best;
}

/// For each descriptor of `from` the index of its nearest in `to`; of equals, the lowest.
std::vector<std::uint32_t> nearest_descriptors(const std::vector<Descriptor>& from, const std::vector<Descriptor>& to) {
  const Strips strips = make_strips(to);
  std::vector<std::uint32_t> nearest(from.size(), 0);
  for_blocks(from.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    std::array<float, kBlock> best;
    best.fill(std::numeric_limits<float>::max());
    std::array<float, kStrip> score;
    for (std::size_t strip = 0; strip < strips.count; ++strip) {
      for (std::size_t i = begin; i < end; ++i) {
        strip_scores(from[i].data(), strips.value.data() + strip * kStrip * kDims,
                     strips.half_norm.data() + strip * kStrip, score.data());
        const std::size_t lane = lowest(score.data());
        if (score[lane] >= best[i - begin]) continue;
        best[i - begin] = score[lane];
        nearest[i] = static_cast<std::uint32_t>(strip * kStrip + lane);
      }
    }
  });
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
  const std::vector<std::uint32_t> to_target = nearest_descriptors(s, t), to_source = nearest_descriptors(t, s);
  const auto agree = [&](std::uint32_t i, std::uint32_t j) {
    return !R_target_source || (R * source.normal[i]).dot(target.normal[j]) >= kMinNormalCosine;
  };
  std::vector<Match> matches;
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    if ((!mutual || to_source[to_target[i]] == i) && agree(i, to_target[i])) matches.push_back({i, to_target[i]});
  }
  for (std::uint32_t j = 0; j < t.size() && !mutual; ++j) {
    if (to_target[to_source[j]] != j && agree(to_source[j], j)) matches.push_back({to_source[j], j});
  }
  return matches;
}

}  // namespace scanway::registration
