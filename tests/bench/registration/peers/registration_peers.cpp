// Coarse registration and the fine step beside those of PCL and Open3D on the same two clouds, one thread, CPU seconds:
// from the raw clouds to the pose. The peers know nothing of the tracker; they have no way to be told.
//   registration_peers [--data ../shared/data] [--thin N] [--skip-sac-ia] [--skip-yard]
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include "modules/mapper/core/registration/last_step.h"
#include "modules/mapper/core/registration/search.h"
#include "tests/bench/registration/cpu_clock.h"
#include "tests/bench/registration/peers/open3d_peers.h"
#include "tests/bench/registration/peers/pcl_peers.h"
#include "tests/bench/registration/real_pairs.h"
#include "tests/bench/registration/simulated/simulated_sweep.h"

namespace {

using namespace scanway;
using namespace scanway::bench;

struct Case {
  std::string name;
  PointCloud source, target;
  Eigen::Vector3d source_origin = Eigen::Vector3d::Zero(), target_origin = Eigen::Vector3d::Zero();
  Pose truth;  ///< T_target_source
  OrientationPrior prior;
};

Case hall_case(const std::string& data) {
  RealSet set = load_set(data, "hall_scans_a");
  Random random(1);
  const Pose truth = set.T_target_source(1, 0);
  return {"real halls",
          std::move(set.clouds[1]),
          std::move(set.clouds[0]),
          Eigen::Vector3d::Zero(),
          Eigen::Vector3d::Zero(),
          truth,
          disturbed_prior(truth, 5.0, 0.5, random)};
}

Case yard_case(double distance_m, int thin) {
  SimulatedPair pair = simulate_pair("yard", 1, distance_m, thin);
  return {"simulated yard, " + std::to_string(static_cast<int>(distance_m)) + " m",
          std::move(pair.source.cloud),
          std::move(pair.target.cloud),
          pair.source.origin,
          pair.target.origin,
          pair.T_target_source(),
          pair.prior()};
}

Pose between_sensors(const Case& c, const Pose& T) {
  return Eigen::Translation3d(-c.target_origin) * T * Eigen::Translation3d(c.source_origin);
}

Pose between_scans(const Case& c, const Pose& T) {
  return Eigen::Translation3d(c.target_origin) * T * Eigen::Translation3d(-c.source_origin);
}

/// Preparing both scans (with what the fine step and the verdict need, too) and the ranked candidates.
PeerAnswer our_coarse(const Case& c, bool tracked) {
  const double begin = cpu_s();
  const PreparedScan source = PreparedScan::make(c.source, c.source_origin, {});
  const PreparedScan target = PreparedScan::make(c.target, c.target_origin, {});
  std::optional<registration::RotationBounds> bounds;
  if (tracked) bounds = registration::bounds_of(c.prior);
  const auto candidates =
      registration::find_candidates(source.data(), target.data(), bounds, registration::SearchWidth::mutual, nullptr);
  PeerAnswer answer{tracked ? "Scanway, with the tracker" : "Scanway, without", Pose::Identity(), cpu_s() - begin};
  if (!candidates.empty()) answer.T_target_source = between_scans(c, candidates.front().T_target_source);
  return answer;
}

/// From prepared scans: what the others need for their fine step (voxels, normals) was made before.
PeerAnswer our_fine(const Case& c, const Pose& start) {
  const double begin = cpu_s();
  const PreparedScan source = PreparedScan::make(c.source, c.source_origin, {});
  const PreparedScan target = PreparedScan::make(c.target, c.target_origin, {});
  const auto icp = registration::refine_finely(source.data(), target.data(), between_sensors(c, start));
  const auto last = registration::take_last_step(source.data(), target.data(), icp.T_target_source);
  return {"Scanway, ICP and last step (and features)", between_scans(c, last.T_target_source), cpu_s() - begin};
}

void print(const Case& c, const PeerAnswer& answer, double ours_s) {
  const PoseError error = error_of(answer.T_target_source, c.truth);
  std::printf("| %s | %s | %.2f | %.1f | %.4f m, %.3f degrees |\n", c.name.c_str(), answer.method.c_str(), answer.cpu_s,
              answer.cpu_s / ours_s, error.metres, error.radians * 57.29577951);
  std::fflush(stdout);
}

void compare_coarse(const Case& c, bool sac_ia) {
  const PeerAnswer ours = our_coarse(c, true);
  print(c, ours, ours.cpu_s);
  print(c, our_coarse(c, false), ours.cpu_s);
#if SCANWAY_WITH_OPEN3D
  print(c, open3d_fgr(c.source, c.target), ours.cpu_s);
  print(c, open3d_ransac(c.source, c.target), ours.cpu_s);
#endif
  print(c, pcl_prerejective(c.source, c.target), ours.cpu_s);
  if (sac_ia) print(c, pcl_sac_ia(c.source, c.target), ours.cpu_s);
}

void compare_fine(const Case& c) {
  Pose start = c.truth;
  start.linear() = rotation_about_z(2.0 / 57.29577951) * c.truth.linear();
  start.translation() += Eigen::Vector3d(0.2, 0.2, 0.1);
  const PeerAnswer ours = our_fine(c, start);
  print(c, ours, ours.cpu_s);
#if SCANWAY_WITH_OPEN3D
  print(c, open3d_icp_planes(c.source, c.target, start), ours.cpu_s);
#endif
  print(c, pcl_icp_planes(c.source, c.target, start), ours.cpu_s);
  print(c, pcl_icp_points(c.source, c.target, start), ours.cpu_s);
}

}  // namespace

int main(int argc, char** argv) {
  std::string data = "../shared/data";
  int thin = 1;
  bool skip_sac_ia = false, skip_yard = false;
  CLI::App app{"Registration beside PCL's and Open3D's"};
  app.add_option("--data", data);
  app.add_option("--thin", thin, "Of the simulated sweeps: only every thin-th line and beam");
  app.add_flag("--skip-sac-ia", skip_sac_ia, "It takes half a minute a pair");
  app.add_flag("--skip-yard", skip_yard, "Only the real halls");
  CLI11_PARSE(app, argc, argv);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  std::vector<Case> cases = {hall_case(data)};
  if (!skip_yard) cases.push_back(yard_case(10.0, thin));
  const char* head = "| clouds | method | CPU s | times ours | error |\n|---|---|---|---|---|\n";
  std::printf("Coarse, from clouds to pose:\n%s", head);
  for (const Case& c : cases) compare_coarse(c, !skip_sac_ia);
  std::printf("\nFine, from clouds to pose, beginning 0.3 m and 2 degrees off:\n%s", head);
  for (const Case& c : cases) compare_fine(c);
}
