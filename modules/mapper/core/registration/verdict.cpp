#include "modules/mapper/core/registration/verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <Eigen/LU>

#include "common/math/repeatable.h"
#include "modules/mapper/core/registration/eigen3.h"

namespace scanway::registration {
namespace {

constexpr double kAcceptedProbability = 0.85;
constexpr double kOpenProbability = 0.2;  // with an open direction: the share that was right all the same
constexpr double kOpenShare = 0.010;      // of the information: the noise of normals alone gives up to 0.009
constexpr double kMinFacing = 16.0;       // surfaces that face a direction: what little is known of it is then no noise
constexpr double kOpenLever = 0.4;   // metres: at this lever surfaces that are 3 mm off turn the scan by 0.4 degrees
constexpr double kMinOverlap = 0.3;  // below, too little of either scan bears the answer

constexpr double kMaxConflict = 0.06;  // things that moved between two scans make up to half of it

constexpr double kTrackedMargin = 1.0;  // with a tracker all rivals are found: a larger margin says no more

constexpr double kRightMetres = 0.1, kRightRadians = 0.5 * repeatable::kPi / 180.0;

double logistic(double z) { return 1.0 / (1.0 + repeatable::exp(-z)); }

/// What n surfaces that agree, and none that does not, say of the next: the rule of succession with Jeffreys' prior.
double succession(double n) { return (n + 0.5) / (n + 1.0); }

std::string format(const char* text, double a, double b = 0.0, double c = 0.0) {
  char buffer[200];
  std::snprintf(buffer, sizeof(buffer), text, a, b, c);
  return buffer;
}

double degrees(double radians) { return radians * 180.0 / repeatable::kPi; }

/// The angle of an axis to x, in (-90, 90] degrees, where a direction and its opposite are one.
double axis_degrees(const Eigen::Vector3d& axis) {
  double angle = degrees(repeatable::atan2(axis.y(), axis.x()));
  if (angle > 90.0) angle -= 180.0;
  if (angle <= -90.0) angle += 180.0;
  return angle;
}

std::string translation_name(const Eigen::Vector3d& axis) {
  if (std::fabs(axis.z()) > 0.8) return "slides up and down";
  return format("slides along the scene, %.0f degrees from x", axis_degrees(axis));
}

std::string rotation_name(const Eigen::Vector3d& axis) {
  if (std::fabs(axis.z()) > 0.8) return "turns about the vertical";
  return format("tilts about an axis %.0f degrees from x", axis_degrees(axis));
}

/// What a 3x3 part knows once the other part is free as well (Schur complement).
Eigen::Matrix3d marginal(const Eigen::Matrix3d& own, const Eigen::Matrix3d& cross, const Eigen::Matrix3d& other) {
  const double damping = 1e-9 * other.trace() + 1e-300;
  return own - cross * (other + damping * Eigen::Matrix3d::Identity()).inverse() * cross.transpose();
}

}  // namespace

// A logistic model, fitted to right and wrong candidates of the real sets. It orders poses; the verdict has its own.
double rank_of(const Evidence& e) {
  return -10.542 + 2.543 * e.agreement.surface_fit - 2.494 * repeatable::log(e.agreement.conflict + 0.003);
}

// Both models fitted by tests/bench/registration/fit_verdict.py. Without a tracker the margin says less: a hall turned
// by half a turn may fit well where the right pose shows too little to be found. Of two poses that exclude each other
// the better cannot be surer than the margin, which is in log-odds.
double probability_right(const Evidence& e) {
  const double margin = std::clamp(e.margin, -kMaxMargin, kMaxMargin);
  const double place = -12.18 - 2.00 * repeatable::log(e.agreement.conflict + 0.003) + 0.33 * e.agreement.surface_fit -
                       1.10 * repeatable::log(e.held_fit + 0.01) + 1.04 * margin +
                       (e.tracked ? 3.06 * std::min(margin, kTrackedMargin) : -0.34);
  const double sigma = std::max(e.sigma_m / kRightMetres, e.sigma_rad / kRightRadians);
  const double precise = -6.06 - 2.22 * repeatable::log(std::min(sigma, 10.0) + 0.003) +
                         1.42 * repeatable::log(static_cast<double>(e.matches) + 1.0);
  return std::min({logistic(place), succession(e.facing), logistic(e.margin)}) * logistic(precise);
}

Observability observe(const IcpResult& icp) {
  if (!(icp.plain_weight > 0.0))
    return {symmetric_eigen(Eigen::Matrix3d::Zero()), symmetric_eigen(Eigen::Matrix3d::Zero())};
  const Matrix6 share = icp.plain_information / icp.plain_weight;
  const Eigen::Matrix3d rr = share.topLeftCorner<3, 3>();
  const Eigen::Matrix3d tt = share.bottomRightCorner<3, 3>();
  const Eigen::Matrix3d rt = share.topRightCorner<3, 3>();
  return {symmetric_eigen(marginal(tt, rt.transpose(), rr)), symmetric_eigen(marginal(rr, rt, tt))};
}

std::vector<std::string> open_directions(const Observability& observability, const Eigen::Vector3d& facing) {
  std::vector<std::string> open;
  const auto& [translation, rotation] = observability;
  for (int k = 0; k < 3; ++k) {
    if (translation.values[k] < kOpenShare && facing[k] < kMinFacing) {
      open.push_back(translation_name(translation.vectors.col(k)));
    }
    if (rotation.values[k] < kOpenLever * kOpenLever) open.push_back(rotation_name(rotation.vectors.col(k)));
  }
  return open;
}

bool contradicts(const Agreement& agreement) { return agreement.conflict > kMaxConflict; }

void decide(const Evidence& evidence, RegistrationResult& result) {
  result.probability = probability_right(evidence);
  const Agreement& a = evidence.agreement;
  const std::string figures = format("%.0f %% overlap, %.1f %% of the points where the other scan saw through",
                                     100.0 * a.overlap, 100.0 * a.conflict);
  result.verdict = Verdict::refused;
  if (!result.open_directions.empty()) {
    result.probability = std::min(result.probability, kOpenProbability);
    result.reason = "The scene leaves a motion open: " + result.open_directions.front() + ".";
  } else if (std::min(a.overlap, a.overlap_back) < kMinOverlap) {
    result.probability = std::min(result.probability, 0.5);
    result.reason = "The scans share too little: " + figures + ".";
  } else if (contradicts(a)) {
    result.probability = std::min(result.probability, 0.5);
    result.reason = "Each scan saw through what the other shows: " + figures + ".";
  } else if (result.probability >= kAcceptedProbability) {
    result.verdict = Verdict::accepted;
    result.reason = format("The scans agree within %.0f mm: ", 1000.0 * result.inlier_rmse_m) + figures + ".";
  } else if (evidence.margin < 0.5) {
    result.reason = "Another pose fits almost as well: " + figures + ".";
  } else {
    result.reason = "The scans do not agree well enough at any pose: " + figures + ".";
  }
}

}  // namespace scanway::registration
