#include "modules/mapper/core/registration/icp.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include "common/parallel/blocks.h"

namespace scanway::registration {
namespace {

constexpr std::size_t kBlock = 512;
constexpr float kMinNormalCosine = 0.8f;
constexpr float kReachInCells = 1.5f;  // the next piece of the same surface is one cell away, or a gap between beams
constexpr float kKernelDeviations = 3.0f, kMinKernel = 0.03f;
constexpr double kConvergedRotation = 2e-5, kConvergedTranslation = 1e-4;
constexpr std::size_t kMinCorrespondences = 12;

struct Sums {
  Matrix6 A = Matrix6::Zero(), plain = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  double weight = 0.0, plain_weight = 0.0, squares = 0.0, lever = 0.0;
  std::size_t count = 0;

  Sums& operator+=(const Sums& other) {
    A += other.A;
    plain += other.plain;
    plain_weight += other.plain_weight;
    b += other.b;
    weight += other.weight;
    squares += other.squares;
    lever += other.lever;
    count += other.count;
    return *this;
  }
};

/// For each of the source's surfaces, the position of what it was nearest to in the iteration before: most often still.
using Hints = std::vector<std::uint32_t>;

/// Normal equations at the pose (R, t), over the source's surfaces [begin, end).
struct Linearisation {
  const Surfaces& source;
  const IcpTarget& target;
  Eigen::Matrix3f R;
  Eigen::Vector3f t;
  IcpRound round;
  Hints& hints;

  Sums operator()(std::size_t begin, std::size_t end) const {
    Sums sums;
    for (std::size_t i = begin; i < end; ++i) add(i, sums);
    return sums;
  }

  void add(std::size_t i, Sums& sums) const {
    const Eigen::Vector3f lever = R * source.centre[i], point = lever + t, normal = R * source.normal[i];
    const float reach = std::max(round.max_distance_m, kReachInCells * source.size[i]);
    const auto original = [&](std::uint32_t position) { return target.grid.original()[position]; };
    const auto admit = [&](std::uint32_t position) {
      return normal.dot(target.surfaces.normal[original(position)]) > kMinNormalCosine;
    };
    const CellGrid::Nearest nearest = target.grid.nearest(point, reach, admit, hints[i]);
    hints[i] = nearest.position;
    if (!nearest.found()) return;
    const std::uint32_t j = original(nearest.position);
    const Eigen::Vector3f both = (normal + target.surfaces.normal[j]).normalized();
    const double residual = both.dot(point - target.surfaces.centre[j]);
    const double scale = static_cast<double>(round.kernel_m) * round.kernel_m;
    const double root = scale / (scale + residual * residual);
    const double plain = root * root, weight = source.weight[i] * plain;
    Vector6 J;
    J << lever.cross(both).cast<double>(), both.cast<double>();
    const Matrix6 outer = J * J.transpose();
    sums.A += weight * outer;
    sums.plain += plain * outer;
    sums.plain_weight += plain;
    sums.b -= weight * residual * J;
    sums.weight += weight;
    sums.squares += weight * residual * residual;
    sums.lever += weight * static_cast<double>(lever.squaredNorm());
    ++sums.count;
  }
};

Sums linearise(const Surfaces& source, const IcpTarget& target, const Pose& T, const IcpRound& round, Hints& hints) {
  const Linearisation at{source, target, T.linear().cast<float>(), T.translation().cast<float>(), round, hints};
  return sum_blocks(source.count(), kBlock, Sums{}, at);
}

/// A little damping in the units of the problem (a metre of lever) holds directions that the scene leaves open.
Vector6 solve(const Sums& sums) {
  const double damping = 1e-4 * sums.weight, lever2 = sums.lever / sums.weight;
  Matrix6 A = sums.A;
  for (int k = 0; k < 3; ++k) A(k, k) += damping * lever2;
  for (int k = 3; k < 6; ++k) A(k, k) += damping;
  return A.ldlt().solve(sums.b);
}

void record(const Sums& sums, IcpResult& result) {
  result.information = sums.A;
  result.weight = sums.weight;
  result.plain_information = sums.plain;
  result.plain_weight = sums.plain_weight;
  result.inliers = sums.count;
  result.rmse_m = sums.weight > 0.0 ? std::sqrt(sums.squares / sums.weight) : 0.0;
  result.lever_m = sums.weight > 0.0 ? std::sqrt(sums.lever / sums.weight) : 1.0;
}

}  // namespace

IcpResult run_icp(const Surfaces& source, const IcpTarget& target, const Pose& T_target_source,
                  std::span<const IcpRound> rounds) {
  IcpResult result;
  result.T_target_source = T_target_source;
  Hints hints(source.count(), CellTable::kNone);
  for (IcpRound round : rounds) {
    if (round.tighten) {
      round.kernel_m = std::clamp(kKernelDeviations * static_cast<float>(result.rmse_m), kMinKernel, round.kernel_m);
    }
    for (int iteration = 0; iteration < round.iterations; ++iteration) {
      const Sums sums = linearise(source, target, result.T_target_source, round, hints);
      record(sums, result);
      if (sums.count < kMinCorrespondences) return result;
      const Vector6 step = solve(sums);
      if (!step.allFinite()) return result;
      const Eigen::Matrix3d turned = exp_so3(step.head<3>()) * result.T_target_source.linear();
      result.T_target_source.linear() = nearest_rotation(turned);
      result.T_target_source.translation() += step.tail<3>();
      if (step.head<3>().norm() < kConvergedRotation && step.tail<3>().norm() < kConvergedTranslation) break;
    }
  }
  return result;
}

}  // namespace scanway::registration
