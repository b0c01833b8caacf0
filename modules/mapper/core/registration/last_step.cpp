#include "modules/mapper/core/registration/last_step.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/registration/eigen3.h"

namespace scanway::registration {
namespace {

constexpr std::size_t kBlock = 256, kParts = 16, kMinMatches = 12;
constexpr float kPart = 4.0f;          // metres: larger than most things, smaller than most scenes
constexpr float kRadius = 0.6f;        // of a plane, in edges of the source's cell
constexpr double kMinPoints = 6.0;     // of a plane
constexpr double kMaxThickness = 0.1;  // deviation across a plane, in its radii
constexpr double kMinExtent = 0.25;    // deviation along its shorter axis, in its radii
constexpr float kMinNormalCosine = 0.95f;
constexpr double kFloor = 0.004;  // metres: what two planes of one surface differ by, however many points they have
constexpr double kKernel = 0.04;  // metres: scale of the robust kernel
constexpr int kPasses = 2, kSteps = 3;
constexpr double kUnknown = 1e-6;  // damping, as a share of the information

struct Plane {
  Eigen::Vector3f mean, normal;
  double variance = -1.0;  ///< Of the mean along the normal; negative: no plane.
};

/// The plane through the points within `radius` of `place`.
Plane plane_at(const CellGrid& points, const Eigen::Vector3f& place, float radius) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  Eigen::Matrix3f outer = Eigen::Matrix3f::Zero();
  float count = 0.0f;
  points.for_each_within(place, radius, [&](std::uint32_t i, float) {
    const Eigen::Vector3f d = points.points()[i] - place;
    sum += d;
    outer += d * d.transpose();
    count += 1.0f;
  });
  Plane plane;
  if (count < kMinPoints) return plane;
  const Eigen::Vector3d mean = sum.cast<double>() / count;
  const Eigen3 eigen = symmetric_eigen(outer.cast<double>() / count - mean * mean.transpose());
  const double thickness2 = std::max(0.0, eigen.values[0]), r2 = static_cast<double>(radius) * radius;
  if (thickness2 > kMaxThickness * kMaxThickness * r2 || eigen.values[1] < kMinExtent * kMinExtent * r2) return plane;
  plane.mean = place + mean.cast<float>();
  plane.normal = eigen.vectors.col(0).cast<float>();
  plane.variance = thickness2 / static_cast<double>(count);
  return plane;
}

struct PlaneMatch {
  Eigen::Vector3f centre;  ///< In the source's frame.
  Eigen::Vector3f mean, normal;
  double information = 0.0;  ///< 1 / variance of the distance; 0: no match.
  std::size_t part = 0;
};

std::size_t part_of(const Eigen::Vector3f& p) {
  const Eigen::Vector3f cube = p / kPart;
  return mix(cell_key(floor_to_int(cube.x()), floor_to_int(cube.y()), floor_to_int(cube.z()))) % kParts;
}

PlaneMatch match(const Surfaces& surfaces, std::size_t i, const CellGrid& target, const Eigen::Matrix3f& R,
                 const Eigen::Vector3f& t) {
  PlaneMatch found{surfaces.centre[i], {}, {}, 0.0, part_of(surfaces.centre[i])};
  const Eigen::Vector3f normal = R * surfaces.normal[i];
  const Plane plane = plane_at(target, R * surfaces.centre[i] + t, kRadius * surfaces.size[i]);
  if (plane.variance < 0.0 || std::fabs(plane.normal.dot(normal)) < kMinNormalCosine) return found;
  found.mean = plane.mean;
  found.normal = (normal + std::copysign(1.0f, plane.normal.dot(normal)) * plane.normal).normalized();
  found.information = 1.0 / (kFloor * kFloor + plane.variance + surfaces.variance[i]);
  return found;
}

std::vector<PlaneMatch> match_all(const Surfaces& surfaces, const CellGrid& target, const Pose& T) {
  const Eigen::Matrix3f R = T.linear().cast<float>();
  const Eigen::Vector3f t = T.translation().cast<float>();
  std::vector<PlaneMatch> matches(surfaces.count());
  for_blocks(matches.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) matches[i] = match(surfaces, i, target, R, t);
  });
  return matches;
}

struct Normal {
  Matrix6 A = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  double weight = 0.0, squares = 0.0;
  std::size_t count = 0;

  Normal& operator+=(const Normal& other) {
    A += other.A, b += other.b;
    weight += other.weight, squares += other.squares, count += other.count;
    return *this;
  }
  Vector6 solve() const {
    Matrix6 damped = A;
    damped.diagonal() += Vector6::Constant(kUnknown * A.trace() + 1e-12);
    return damped.ldlt().solve(b);
  }
};

using Parts = std::array<Normal, kParts>;

void add(const PlaneMatch& m, const Pose& T, Normal& sums) {
  const Eigen::Vector3d lever = T.linear() * m.centre.cast<double>();
  const Eigen::Vector3d normal = m.normal.cast<double>();
  const double residual = normal.dot(lever + T.translation() - m.mean.cast<double>());
  const double root = kKernel * kKernel / (kKernel * kKernel + residual * residual);
  const double weight = m.information * root * root;
  Vector6 J;
  J << lever.cross(normal), normal;
  sums.A += weight * J * J.transpose();
  sums.b -= weight * residual * J;
  sums.weight += weight;
  sums.squares += weight * residual * residual;
  ++sums.count;
}

Parts linearise(const std::vector<PlaneMatch>& matches, const Pose& T) {
  Parts parts;
  for (const PlaneMatch& m : matches) {
    if (m.information > 0.0) add(m, T, parts[m.part]);
  }
  return parts;
}

Normal total_of(const Parts& parts) {
  Normal total;
  for (const Normal& part : parts) total += part;
  return total;
}

Matrix6 jackknife(const Parts& parts) {
  std::array<Vector6, kParts> without;
  Vector6 mean = Vector6::Zero();
  for (std::size_t left_out = 0; left_out < kParts; ++left_out) {
    Normal rest;
    for (std::size_t p = 0; p < kParts; ++p) {
      if (p != left_out) rest += parts[p];
    }
    without[left_out] = rest.solve();
    mean += without[left_out] / static_cast<double>(kParts);
  }
  Matrix6 covariance = Matrix6::Zero();
  for (const Vector6& x : without) covariance += (x - mean) * (x - mean).transpose();
  return covariance * (static_cast<double>(kParts - 1) / static_cast<double>(kParts));
}

Matrix6 inverse_of(const Matrix6& information) {
  Matrix6 damped = information;
  damped.diagonal() += Vector6::Constant(kUnknown * information.trace() + 1e-12);
  return damped.inverse();
}

double largest_sigma(const Eigen::Matrix3d& covariance) {
  return std::sqrt(std::max(0.0, symmetric_eigen(covariance).values[2]));
}

}  // namespace

double sigma_m(const Matrix6& covariance) { return largest_sigma(covariance.bottomRightCorner<3, 3>()); }
double sigma_rad(const Matrix6& covariance) { return largest_sigma(covariance.topLeftCorner<3, 3>()); }

LastStep take_last_step(const PreparedScan::Data& source, const PreparedScan::Data& target,
                        const Pose& T_target_source) {
  LastStep last;
  last.T_target_source = T_target_source;
  Parts parts;
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<PlaneMatch> matches = match_all(source.surfaces, target.fine, last.T_target_source);
    for (int step = 0; step < kSteps; ++step) {
      const Normal total = total_of(linearise(matches, last.T_target_source));
      const Vector6 x = total.solve();
      if (total.count < kMinMatches || !x.allFinite()) return {T_target_source};
      last.T_target_source.linear() = nearest_rotation(exp_so3(x.head<3>()) * last.T_target_source.linear());
      last.T_target_source.translation() += x.tail<3>();
    }
    parts = linearise(matches, last.T_target_source);
  }
  const Normal total = total_of(parts);
  last.covariance = jackknife(parts) + inverse_of(total.A);
  last.matches = total.count;
  last.rmse_m = std::sqrt(total.squares / total.weight);
  last.moved_m = (last.T_target_source.translation() - T_target_source.translation()).norm();
  return last;
}

}  // namespace scanway::registration
