#include "modules/tools/clouds/register.h"

#include <cmath>
#include <cstdio>
#include <exception>
#include <utility>

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>
#include <nlohmann/json.hpp>

#include "common/cloud/read_cloud.h"
#include "common/files/input_error.h"
#include "common/progress/stage_timer.h"
#include "modules/mapper/core/registration/registration.h"

namespace scanway::tools {
namespace {

OrientationPrior prior_from(const std::array<double, 4>& wxyz) {
  const double norm = std::sqrt(wxyz[0] * wxyz[0] + wxyz[1] * wxyz[1] + wxyz[2] * wxyz[2] + wxyz[3] * wxyz[3]);
  if (!std::isfinite(norm) || norm < 1e-6) {
    throw InputError(
        fmt::format("--orientation {},{},{},{}: no rotation; give a quaternion qw,qx,qy,qz that is not zero", wxyz[0],
                    wxyz[1], wxyz[2], wxyz[3]));
  }
  OrientationPrior prior;
  prior.R_target_source =
      Eigen::Quaterniond(wxyz[0] / norm, wxyz[1] / norm, wxyz[2] / norm, wxyz[3] / norm).toRotationMatrix();
  return prior;
}

const char* name_of(Verdict verdict) { return verdict == Verdict::accepted ? "accepted" : "refused"; }

void print_json(const RegistrationResult& result, StageTimer& timer) {
  nlohmann::ordered_json json;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      json["T_target_source"].push_back(result.T_target_source.matrix()(row, column));
    }
  }
  json["verdict"] = name_of(result.verdict);
  json["probability"] = result.probability;
  json["overlap"] = result.overlap;
  json["inlier_rmse_m"] = result.inlier_rmse_m;
  json["reason"] = result.reason;
  json["open_directions"] = result.open_directions;
  for (const auto& [stage, seconds] : timer.finish()) json["seconds"][stage] = seconds;
  json["seconds"]["total"] = timer.total_s();
  std::puts(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

void print_text(const RegistrationResult& result, StageTimer& timer) {
  fmt::print("{} (probability {:.3f}): {}\n", name_of(result.verdict), result.probability, result.reason);
  for (const std::string& motion : result.open_directions) fmt::print("open: {}\n", motion);
  fmt::print("T_target_source\n");
  for (int row = 0; row < 4; ++row) {
    const auto& T = result.T_target_source.matrix();
    fmt::print("  {:12.8f} {:12.8f} {:12.8f} {:12.5f}\n", T(row, 0), T(row, 1), T(row, 2), T(row, 3));
  }
  fmt::print("seconds:");
  for (const auto& [stage, seconds] : timer.finish()) fmt::print(" {} {:.3f},", stage, seconds);
  fmt::print(" total {:.3f}\n", timer.total_s());
}

/// The scan in a file. Its cloud goes once it is prepared.
PreparedScan prepared_from(const std::string& path) {
  return PreparedScan::make(read_scan(path), Eigen::Vector3d::Zero(), {});
}

/// One of the two, or what was wrong with it.
struct Side {
  PreparedScan scan;
  std::exception_ptr trouble;

  void load(const std::string& path) {
    try {
      scan = prepared_from(path);
    } catch (...) {
      trouble = std::current_exception();
    }
  }
};

/// Side by side. Of two bad files the source is the one that is named, whichever was read first.
std::pair<PreparedScan, PreparedScan> load(const RegisterOptions& options) {
  Side source, target;
  tbb::parallel_invoke([&] { source.load(options.source); }, [&] { target.load(options.target); });
  for (const Side* side : {&source, &target}) {
    if (side->trouble) std::rethrow_exception(side->trouble);
  }
  return {source.scan, target.scan};
}

}  // namespace

int run_register(const RegisterOptions& options) {
  std::optional<OrientationPrior> prior;
  if (options.orientation_wxyz) prior = prior_from(*options.orientation_wxyz);
  StageTimer timer;
  timer.begin("prepare");
  const auto [source, target] = load(options);
  const RegistrationResult result = register_scans(source, target, prior, {}, &timer);
  timer.finish();
  if (options.json) {
    print_json(result, timer);
  } else {
    print_text(result, timer);
  }
  return 0;
}

}  // namespace scanway::tools
