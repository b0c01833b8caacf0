#include "tests/bench/registration/paper/whole_pair.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <new>
#include <vector>

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

/// CPU seconds of this thread.
double thread_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double peak_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

PointCloud in_sensor_frame(SimulatedCloud scan) {
  for (Eigen::Vector3f& p : scan.cloud.points) p = (p.cast<double>() - scan.origin).cast<float>();
  return std::move(scan.cloud);
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

/// What one process measured of itself.
struct Measured {
  double read_s = 0.0, prepare_s = 0.0, register_s = 0.0;  // wall
  double cpu_s = 0.0, first_thread_s = 0.0, peak_mb = 0.0, input_mb = 0.0, program_mb = 0.0;
  double points = 0.0, millimetres = 0.0, probability = 0.0;
  bool done = false, accepted = false;

  double wall_s() const { return read_s + prepare_s + register_s; }
};

double megabytes(const PointCloud& cloud) {
  return static_cast<double>(cloud.size() * sizeof(Eigen::Vector3f) + cloud.intensity.size() * sizeof(float)) /
         (1024.0 * 1024.0);
}

Measured measure(const std::string& folder, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  std::ifstream file(folder + "/pair.txt");
  const Pose truth = read_matrix(file);
  OrientationPrior prior;
  prior.R_target_source = read_matrix(file).linear();
  if (!file) throw InputError(folder + "/pair.txt: cannot be read; make the pair with `registration_paper write`");
  Measured measured;
  measured.program_mb = peak_mb();
  const double cpu = cpu_s(), thread = thread_s(), begin = wall_s();
  PointCloud source_cloud, target_cloud;
  tbb::parallel_invoke([&] { source_cloud = read_scan(folder + "/source.pcd"); },
                       [&] { target_cloud = read_scan(folder + "/target.pcd"); });
  const double read = wall_s();
  PreparedScan source, target;
  tbb::parallel_invoke([&] { source = PreparedScan::make(source_cloud, Eigen::Vector3d::Zero(), {}); },
                       [&] { target = PreparedScan::make(target_cloud, Eigen::Vector3d::Zero(), {}); });
  const double prepared = wall_s();
  const RegistrationResult result = register_scans(source, target, prior, {});
  measured.register_s = wall_s() - prepared;
  measured.prepare_s = prepared - read;
  measured.read_s = read - begin;
  measured.cpu_s = cpu_s() - cpu;
  measured.first_thread_s = thread_s() - thread;
  measured.peak_mb = peak_mb();
  measured.input_mb = megabytes(source_cloud) + megabytes(target_cloud);
  measured.points = static_cast<double>(source_cloud.size() + target_cloud.size()) / 2e6;
  measured.accepted = result.verdict == Verdict::accepted;
  measured.probability = result.probability;
  measured.millimetres = 1000.0 * error_of(result.T_target_source, truth).metres;
  measured.done = true;
  return measured;
}

/// In a process of its own, or the peak is that of what ran before.
Measured measure_apart(const std::string& folder, int threads) {
  void* shared = mmap(nullptr, sizeof(Measured), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw InputError("no memory to share with the measuring process");
  auto* measured = new (shared) Measured;
  const pid_t child = fork();
  if (child == 0) {
    try {
      *measured = measure(folder, threads);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  const Measured result = *measured;
  munmap(shared, sizeof(Measured));
  if (!result.done) throw InputError(folder + ": the measuring process ended without a result");
  return result;
}

void print(int threads, const Measured& m) {
  std::printf(
      "%d threads: wall %.3f s (read %.3f, prepare %.3f, register %.3f), CPU %.3f s (the first thread %.3f), peak %.0f "
      "MB: %.0f MB above the "
      "clouds' %.0f MB; %.2f million points a sweep, %s, p %.3f, %.2f mm\n",
      threads, m.wall_s(), m.read_s, m.prepare_s, m.register_s, m.cpu_s, m.first_thread_s, m.peak_mb,
      m.peak_mb - m.input_mb - m.program_mb, m.input_mb, m.points, m.accepted ? "accepted" : "refused", m.probability,
      m.millimetres);
  std::fflush(stdout);
}

double median_wall(std::vector<Measured> runs) {
  std::sort(runs.begin(), runs.end(), [](const Measured& a, const Measured& b) { return a.wall_s() < b.wall_s(); });
  return runs[runs.size() / 2].wall_s();
}

}  // namespace

void write_whole_pair(const std::string& folder, const std::string& world, double distance_m, double slower) {
  SimulatedPair pair = simulate_pair(world, 1, distance_m, 1, slower);
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

void run_whole_pair(const std::string& folder, int runs) {
  std::vector<Measured> one, two;
  for (int run = 0; run < runs; ++run) {
    one.push_back(measure_apart(folder, 1));
    print(1, one.back());
    two.push_back(measure_apart(folder, 2));
    print(2, two.back());
  }
  std::printf("medians of %d: one thread %.3f s, two %.3f s, %.2f times faster\n", runs, median_wall(one),
              median_wall(two), median_wall(one) / median_wall(two));
}

}  // namespace scanway::bench
