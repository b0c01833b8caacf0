#include "modules/mapper/core/registration/consensus.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/math/repeatable.h"
#include "common/parallel/blocks.h"
#include "modules/mapper/core/registration/compatibility.h"
#include "modules/mapper/core/registration/rigid.h"

namespace scanway::registration {
namespace {

constexpr float kNormalTolerance = 0.35f;   // of cosines between normals and lines
constexpr std::size_t kGroup = 24;          // matches of a seed's first pose
constexpr double kMaxTiltFreeCosine = 0.5;  // both scans within 30 degrees of upright: 60 degrees between them
constexpr std::size_t kMinVotes = 4;

struct Oriented {
  Eigen::Vector3f p, q;  ///< Source (turned by the tracker's rotation, if there is one) and target point.
  Eigen::Vector3f n, m;  ///< Their normals.
};

struct PairTest {
  float tolerance, min_baseline;
  bool turned;          ///< The tracker's rotation is applied: difference vectors are comparable.
  float heading, tilt;  ///< Its bounds.

  bool operator()(const Oriented& a, const Oriented& b) const {
    const Eigen::Vector3f d = b.p - a.p, e = b.q - a.q;
    const float d2 = d.squaredNorm(), e2 = e.squaredNorm();
    if (d2 < min_baseline * min_baseline || e2 < min_baseline * min_baseline) return false;
    if (turned) {
      const float length = std::sqrt(d2);
      if (std::fabs(d.z() - e.z()) > tolerance + tilt * length) return false;
      if ((d - e).squaredNorm() > square(tolerance + heading * length)) return false;
    }
    const float ld = std::sqrt(d2), le = std::sqrt(e2);
    if (std::fabs(ld - le) > tolerance) return false;
    if (std::fabs(a.n.dot(b.n) - a.m.dot(b.m)) > kNormalTolerance) return false;
    if (std::fabs(a.n.dot(d) / ld - a.m.dot(e) / le) > kNormalTolerance) return false;
    return std::fabs(b.n.dot(d) / ld - b.m.dot(e) / le) <= kNormalTolerance;
  }
  static float square(float v) { return v * v; }
};

std::vector<Oriented> orient(const Keypoints& source, const Keypoints& target, const std::vector<Match>& matches,
                             const std::optional<RotationBounds>& bounds) {
  Eigen::Matrix3f R = Eigen::Matrix3f::Identity();
  if (bounds) R = bounds->R_target_source.cast<float>();
  std::vector<Oriented> oriented;
  oriented.reserve(matches.size());
  for (const Match& m : matches) {
    oriented.push_back(
        {R * source.point[m.source], target.point[m.target], R * source.normal[m.source], target.normal[m.target]});
  }
  return oriented;
}

/// Half of the matrix by the test, the other half mirrored.
Compatibility build(const std::vector<Oriented>& matches, const PairTest& compatible) {
  Compatibility matrix(matches.size());
  for_blocks(matches.size(), 32, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t j = i + 1; j < matches.size(); ++j) {
        if (compatible(matches[i], matches[j])) matrix.set(i, j);
      }
    }
  });
  matrix.mirror();
  return matrix;
}

/// The matches with most compatible others: where poses are fitted from. In rising order.
std::vector<std::uint32_t> choose_seeds(const Compatibility& matrix, std::size_t count) {
  std::vector<std::pair<std::size_t, std::uint32_t>> rank;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) rank.emplace_back(matrix.size() - matrix.common(i, i), i);
  std::sort(rank.begin(), rank.end());
  std::vector<std::uint32_t> seeds;
  for (const auto& [rest, i] : rank) {
    if (seeds.size() < count) seeds.push_back(i);
  }
  std::sort(seeds.begin(), seeds.end());
  return seeds;
}

struct Neighbour {
  std::size_t common;
  std::uint32_t match;
};

/// The matches that share most compatible others with `seed`; of equals, the lowest index.
std::vector<Neighbour> group_of(std::size_t seed, const Compatibility& matrix) {
  std::vector<Neighbour> group;
  for (std::uint32_t j = 0; j < matrix.size(); ++j) {
    if (matrix.test(seed, j)) group.push_back({matrix.common(seed, j), j});
  }
  const std::size_t kept = std::min(group.size(), kGroup);
  std::partial_sort(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(kept), group.end(),
                    [](const Neighbour& a, const Neighbour& b) {
                      return a.common != b.common ? a.common > b.common : a.match < b.match;
                    });
  group.resize(kept);
  return group;
}

class PoseFit {
 public:
  PoseFit(const std::vector<Oriented>& matches, double tolerance_m) : matches_(matches), tolerance_(tolerance_m) {}

  /// The pose of the seed and its group, refitted twice to all matches within the tolerance.
  Hypothesis fit(std::size_t seed, const std::vector<Neighbour>& group) const {
    std::vector<PointPair> pairs = {pair(seed, static_cast<double>(group.front().common))};
    for (const Neighbour& g : group) pairs.push_back(pair(g.match, static_cast<double>(g.common)));
    Hypothesis hypothesis;
    for (int round = 0; round < 3; ++round) {
      hypothesis.T_target_source = rigid_from_pairs(pairs);
      pairs = inliers(hypothesis.T_target_source);
      hypothesis.votes = pairs.size();
      if (pairs.size() < kMinVotes) break;
    }
    return hypothesis;
  }

 private:
  PointPair pair(std::size_t i, double weight) const {
    return {matches_[i].p.cast<double>(), matches_[i].q.cast<double>(), weight};
  }
  std::vector<PointPair> inliers(const Pose& T) const {
    const Eigen::Matrix3f R = T.linear().cast<float>();
    const Eigen::Vector3f t = T.translation().cast<float>();
    const auto limit = static_cast<float>(tolerance_ * tolerance_);
    std::vector<PointPair> found;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      const bool near = (R * matches_[i].p + t - matches_[i].q).squaredNorm() < limit;
      if (near && (R * matches_[i].n).dot(matches_[i].m) > 0.7f) found.push_back(pair(i, 1.0));
    }
    return found;
  }

  const std::vector<Oriented>& matches_;
  double tolerance_;
};

bool same(const Hypothesis& a, const Hypothesis& b, const ConsensusOptions& options) {
  const Pose d = a.T_target_source.inverse() * b.T_target_source;
  return d.translation().norm() < options.distinct_m && rotation_angle(d.linear()) < options.distinct_angle;
}

std::vector<Hypothesis> keep_distinct(std::vector<Hypothesis> all, const ConsensusOptions& options) {
  std::stable_sort(all.begin(), all.end(), [](const Hypothesis& a, const Hypothesis& b) { return a.votes > b.votes; });
  std::vector<Hypothesis> kept;
  for (const Hypothesis& h : all) {
    if (kept.size() == options.max_hypotheses || h.votes < kMinVotes) break;
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Hypothesis& k) { return same(k, h, options); });
    if (!known) kept.push_back(h);
  }
  return kept;
}

PairTest make_test(const std::optional<RotationBounds>& bounds, const ConsensusOptions& options) {
  PairTest test{static_cast<float>(options.tolerance_m), static_cast<float>(options.min_baseline_m), bounds.has_value(),
                0.0f, 0.0f};
  if (bounds) {
    test.heading = static_cast<float>(bounds->heading + bounds->tilt);
    test.tilt = static_cast<float>(bounds->tilt);
  }
  return test;
}

}  // namespace

bool within(const RotationBounds& bounds, const Eigen::Matrix3d& R_target_source) {
  const Eigen::Matrix3d off = R_target_source * bounds.R_target_source.transpose();
  if (off(2, 2) < repeatable::cos(bounds.tilt)) return false;
  return std::fabs(heading_of(off)) <= bounds.heading;
}

std::vector<Hypothesis> find_hypotheses(const Keypoints& source, const Keypoints& target,
                                        const std::vector<Match>& matches, const std::optional<RotationBounds>& bounds,
                                        const ConsensusOptions& options) {
  std::vector<Match> used(matches.begin(),
                          matches.begin() + static_cast<std::ptrdiff_t>(std::min(matches.size(), options.max_matches)));
  const std::vector<Oriented> oriented = orient(source, target, used, bounds);
  const Compatibility matrix = build(oriented, make_test(bounds, options));
  const PoseFit fit(oriented, options.tolerance_m);
  const std::vector<std::uint32_t> seeds = choose_seeds(matrix, options.max_seeds);
  std::vector<Hypothesis> all(seeds.size());
  for_blocks(seeds.size(), 16, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::vector<Neighbour> group = group_of(seeds[i], matrix);
      if (group.size() + 1 >= kMinVotes) all[i] = fit.fit(seeds[i], group);
    }
  });
  Pose prior = Pose::Identity();
  if (bounds) prior.linear() = bounds->R_target_source;
  for (Hypothesis& h : all) {
    h.T_target_source = h.T_target_source * prior;  // the matches' source points were turned already
    const Eigen::Matrix3d R = h.T_target_source.linear();
    if (bounds ? !within(*bounds, R) : R(2, 2) < kMaxTiltFreeCosine) h.votes = 0;
  }
  return keep_distinct(std::move(all), options);
}

}  // namespace scanway::registration
