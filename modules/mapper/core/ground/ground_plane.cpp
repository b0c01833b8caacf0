#include "modules/mapper/core/ground/ground_plane.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/math/repeatable.h"
#include "common/random/random.h"
#include "modules/mapper/core/cloud/radix_sort.h"

namespace scanway {
namespace {

constexpr double kVoterSide = 0.2;
constexpr double kSensorClearance = 0.05;  // the ground is at least this far below the sensor
constexpr double kNear = 2.5;              // a voter at this distance weighs half
constexpr std::size_t kWallCubes = 3;
constexpr int kSamples = 4000;  // triples drawn; most are too steep to be worth counting
constexpr int kRefinements = 4;

/// One point for each 0.2 m cube, relative to the sensor's foot, with its weight.
struct Voter {
  double x, y, z;
  std::int64_t weight;
};

std::vector<Voter> choose_voters(const MapPoints& points, const GroundPlaneConfig& config) {
  struct Entry {
    std::uint64_t key;
    Eigen::Vector3d p;
  };
  std::vector<Entry> entries;
  for (const Eigen::Vector3f& point : points.points) {
    const Eigen::Vector3d p = point.cast<double>() - points.origin;
    const double range2 = p.x() * p.x() + p.y() * p.y();
    if (p.z() > -kSensorClearance || p.z() < -50.0 || range2 > config.max_range_m * config.max_range_m) continue;
    const auto index = [](double v) { return static_cast<std::uint64_t>(std::floor(v / kVoterSide) + 1e6); };
    entries.push_back({index(p.x()) << 42 | index(p.y()) << 21 | index(p.z()), p});
  }
  radix_sort_by_key(entries);
  entries.erase(
      std::unique(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.key == b.key; }),
      entries.end());
  // Sorted, cubes above each other follow each other: three in a row are a wall, and its layers would vote for planes.
  std::vector<Voter> voters;
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    for (end = begin + 1; end < entries.size() && entries[end].key == entries[end - 1].key + 1;) ++end;
    if (end - begin >= kWallCubes) continue;
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d& p = entries[i].p;
      const double range2 = p.x() * p.x() + p.y() * p.y();
      const auto weight = static_cast<std::int64_t>(1024.0 / (1.0 + range2 / (kNear * kNear)));
      voters.push_back({p.x(), p.y(), p.z(), weight});
    }
  }
  return voters;
}

/// z = c + a x + b y, relative to the sensor.
struct Candidate {
  double c = 0.0, a = 0.0, b = 0.0;
  double residual(const Voter& v) const { return v.z - (c + a * v.x + b * v.y); }
};

std::optional<Candidate> through(const Voter& p, const Voter& q, const Voter& r) {
  const double ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
  const double vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
  const double nz = ux * vy - uy * vx;
  if (std::fabs(nz) < 0.05) return std::nullopt;  // too slim a triangle to carry a plane
  Candidate plane;
  plane.a = (uz * vy - uy * vz) / nz;
  plane.b = (ux * vz - uz * vx) / nz;
  plane.c = p.z - plane.a * p.x - plane.b * p.y;
  return plane;
}

bool may_be_ground(const Candidate& plane, const GroundPlaneConfig& config, double max_gradient) {
  if (plane.a * plane.a + plane.b * plane.b > max_gradient * max_gradient) return false;
  if (config.sensor_height_m > 0.0) {
    return std::fabs(-plane.c - config.sensor_height_m) <= config.sensor_height_tolerance_m;
  }
  return plane.c <= -kSensorClearance;
}

/// Weight of the plane's own voters, less half of what lies below it: the ground is the lowest of the large surfaces,
/// but a trench beside it does not outweigh what the robot stands on.
std::int64_t support(const Candidate& plane, const std::vector<Voter>& voters, double inlier) {
  std::int64_t own = 0, below = 0;
  for (const Voter& v : voters) {
    const double residual = plane.residual(v);
    own += std::fabs(residual) <= inlier ? v.weight : 0;
    below += residual < -3.0 * inlier ? v.weight : 0;
  }
  return own - below / 2;
}

Candidate refine(Candidate plane, const std::vector<Voter>& voters, double inlier) {
  for (int round = 0; round < kRefinements; ++round) {
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
    for (const Voter& v : voters) {
      if (std::fabs(plane.residual(v)) > inlier) continue;
      const Eigen::Vector3d row(1.0, v.x, v.y);
      H += row * row.transpose();
      g += v.z * row;
    }
    const double determinant = H.determinant();
    if (!(std::fabs(determinant) > 1e-6)) break;
    const Eigen::Vector3d solution = H.inverse() * g;
    plane = {solution[0], solution[1], solution[2]};
  }
  return plane;
}

}  // namespace

double GroundPlane::distance(const Eigen::Vector3d& p) const {
  return (p.z() - height_at(p.x(), p.y())) / std::sqrt(1.0 + slope_x * slope_x + slope_y * slope_y);
}

std::optional<GroundPlane> find_ground_plane(const MapPoints& points, const GroundPlaneConfig& config) {
  const std::vector<Voter> voters = choose_voters(points, config);
  if (voters.size() < 3) return std::nullopt;
  const double max_gradient = repeatable::sin(config.max_slope) / repeatable::cos(config.max_slope);
  Random random(config.seed);
  Candidate best;
  std::int64_t best_support = 0;
  for (int i = 0; i < kSamples; ++i) {
    const auto draw = [&]() -> const Voter& { return voters[random.below(voters.size())]; };
    const Voter &p = draw(), &q = draw(), &r = draw();
    const std::optional<Candidate> plane = through(p, q, r);
    if (!plane || !may_be_ground(*plane, config, max_gradient)) continue;
    const std::int64_t votes = support(*plane, voters, config.inlier_m);
    if (votes > best_support) best = *plane, best_support = votes;
  }
  if (best_support == 0) return std::nullopt;
  best = refine(best, voters, config.inlier_m);
  if (!may_be_ground(best, config, max_gradient)) return std::nullopt;

  GroundPlane ground{0.0, best.a, best.b};
  double squares = 0.0, count = 0.0;
  for (const Voter& v : voters) {
    const double residual = best.residual(v);
    if (std::fabs(residual) > config.inlier_m) continue;
    squares += residual * residual;
    count += 1.0;
  }
  ground.area_m2 = count * kVoterSide * kVoterSide;
  if (ground.area_m2 < config.min_area_m2) return std::nullopt;
  ground.rms_m = std::sqrt(squares / count);
  const Eigen::Vector3d& o = points.origin;
  ground.height_m = o.z() + best.c - best.a * o.x() - best.b * o.y();
  return ground;
}

}  // namespace scanway
