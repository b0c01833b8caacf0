#include "tests/bench/registration/paper/whole_pair.h"

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <fstream>

#include <tbb/global_control.h>
#include <tbb/parallel_invoke.h>

#include "common/cloud/read_cloud.h"
#include "common/cloud/write_cloud.h"
#include "common/files/input_error.h"
#include "tests/bench/registration/cpu_clock.h"
#include "tests/bench/registration/real_pairs.h"
#include "tests/bench/registration/simulated/simulated_sweep.h"

namespace scanway::bench {
namespace {

double wall_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double peak_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

PointCloud in_sensor_frame(SimulatedCloud scan) {
  for (Eigen::Vector3f& p : scan.cloud.points) p = (p.cast<double>() - scan.origin).cast<float>();
  return std::move(scan.cloud);
}

struct Loaded {
  PreparedScan scan;
  double cloud_mb = 0.0;
};

Loaded load(const std::string& path) {
  const PointCloud cloud = read_scan(path);
  const double bytes = static_cast<double>(cloud.size() * sizeof(Eigen::Vector3f) + cloud.intensity.size() * 4);
  return {PreparedScan::make(cloud, Eigen::Vector3d::Zero(), {}), bytes / (1024.0 * 1024.0)};
}

void write_matrix(std::ofstream& file, const Eigen::Matrix4d& T) {
  file.precision(17);
  for (int i = 0; i < 16; ++i) file << T(i / 4, i % 4) << '\n';
}

Pose read_matrix(std::ifstream& file) {
  Pose T;
  for (int i = 0; i < 16; ++i) file >> T.matrix()(i / 4, i % 4);
  return T;
}

}  // namespace

void write_whole_pair(const std::string& folder, const std::string& world, double distance_m) {
  SimulatedPair pair = simulate_pair(world, 1, distance_m, 1);
  const Pose truth =
      Eigen::Translation3d(-pair.target.origin) * pair.T_target_source() * Eigen::Translation3d(pair.source.origin);
  Pose prior = Pose::Identity();
  prior.linear() = pair.prior().R_target_source;
  write_pcd(folder + "/source.pcd", in_sensor_frame(std::move(pair.source)));
  write_pcd(folder + "/target.pcd", in_sensor_frame(std::move(pair.target)));
  std::ofstream file(folder + "/pair.txt");
  write_matrix(file, truth.matrix());
  write_matrix(file, prior.matrix());
}

void run_whole_pair(const std::string& folder, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  std::ifstream file(folder + "/pair.txt");
  const Pose truth = read_matrix(file);
  OrientationPrior prior;
  prior.R_target_source = read_matrix(file).linear();
  if (!file) throw InputError(folder + "/pair.txt: cannot be read; make the pair with `registration_paper write`");
  const double program_mb = peak_mb(), wall = wall_s(), cpu = cpu_s();
  Loaded source, target;
  tbb::parallel_invoke([&] { source = load(folder + "/source.pcd"); }, [&] { target = load(folder + "/target.pcd"); });
  const RegistrationResult result = register_scans(source.scan, target.scan, prior, {});
  const double wall_taken = wall_s() - wall, cpu_taken = cpu_s() - cpu;
  const double input_mb = source.cloud_mb + target.cloud_mb;
  std::printf(
      "%d threads: wall %.2f s, CPU %.2f s, peak %.0f MB, of it %.0f MB clouds and %.0f MB the program: %.0f MB "
      "above the input; %s, p %.3f, %.2f mm\n",
      threads, wall_taken, cpu_taken, peak_mb(), input_mb, program_mb, peak_mb() - input_mb - program_mb,
      result.verdict == Verdict::accepted ? "accepted" : "refused", result.probability,
      1000.0 * error_of(result.T_target_source, truth).metres);
}

}  // namespace scanway::bench
