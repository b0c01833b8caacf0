#include "modules/tools/clouds/import_clouds.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "common/bus/channels.h"
#include "common/bus/log_bus.h"
#include "common/bus/log_writer.h"
#include "common/cloud/poses_file.h"
#include "common/cloud/read_cloud.h"
#include "common/cloud/sweep.h"
#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/geometry/pose.h"
#include "common/math/repeatable.h"
#include "common/messages/codec.h"
#include "common/messages/goal_message.h"
#include "common/messages/imu_message.h"
#include "common/messages/objects.h"
#include "common/messages/params_message.h"
#include "common/messages/sweep_message.h"
#include "common/random/random.h"
#include "scanway/reference_pose_t.hpp"

namespace scanway::tools {
namespace {

// An imported log begins at 2000-01-01 00:00:00 UTC, whenever it is made: the same clouds give the same bytes. What
// holds for all scans comes first, so that it is in force at every one of them, the last too.
constexpr Utime kLogBegins = 946'684'800 * kMicrosecondsPerSecond;
constexpr Utime kGoalAfterBegin = kMicrosecondsPerSecond / 2;
constexpr Utime kFirstScanAfterBegin = kMicrosecondsPerSecond;
constexpr Utime kBetweenScans = 10 * kMicrosecondsPerSecond;
constexpr Utime kImuBeforeSweep = 10'000;
constexpr Utime kBetweenPieces = 1'000;
constexpr double kRadiansPerDegree = repeatable::kPi / 180.0;

void check(const ImportCloudsOptions& options) {
  const auto bad = [](double value) { return !std::isfinite(value) || value < 0.0; };
  if (options.files.empty()) throw InputError("import clouds: no cloud file is named; name at least one");
  if (!options.poses.empty() && !options.orientation.empty()) {
    throw InputError("import clouds: --poses holds the orientations too; give --poses or --orientation, not both");
  }
  if (bad(options.heading_sigma_deg) || options.heading_sigma_deg > 180.0) {
    throw InputError("import clouds: --heading-sigma-deg must be from 0 to 180");
  }
  if (bad(options.tilt_sigma_deg) || options.tilt_sigma_deg > 90.0) {
    throw InputError("import clouds: --tilt-sigma-deg must be from 0 to 90");
  }
  if (options.sensor_height_m && (bad(*options.sensor_height_m) || *options.sensor_height_m > 100.0)) {
    throw InputError("import clouds: --sensor-height must be from 0 to 100 metres");
  }
  if (options.goal_m && (!std::isfinite(options.goal_m->first) || !std::isfinite(options.goal_m->second))) {
    throw InputError("import clouds: --goal must be two finite numbers, X,Y in metres");
  }
}

/// The scans' names, by which poses and reports go. Two files must not have the same; one file may be there twice.
std::vector<std::string> names_of(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  std::map<std::string, std::string> file_of;
  for (const std::string& file : files) {
    names.push_back(scan_name(file));
    const auto [first, is_new] = file_of.emplace(names.back(), file);
    if (!is_new && first->second != file) {
      throw InputError(printable(file) + ": its scan has the same name as that of " + printable(first->second) + " (" +
                       in_quotes(names.back()) + "); rename one of the files");
    }
    if (names.back().size() > kMaxKeyBytes) {
      throw InputError(printable(file) + ": its name is longer than " + std::to_string(kMaxKeyBytes) +
                       " bytes; rename the file");
    }
  }
  return names;
}

/// Leaves out the points nearer to the sensor than it can measure: the robot itself, or marks for "no return".
std::size_t drop_near_points(PointCloud& cloud, double min_range_m) {
  const auto nearest = static_cast<float>(min_range_m);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.points[i].squaredNorm() < nearest * nearest) continue;
    cloud.points[kept] = cloud.points[i];
    if (!cloud.intensity.empty()) cloud.intensity[kept] = cloud.intensity[i];
    ++kept;
  }
  const std::size_t dropped = cloud.size() - kept;
  cloud.points.resize(kept);
  if (!cloud.intensity.empty()) cloud.intensity.resize(kept);
  return dropped;
}

Sweep read_sweep(const std::string& file, const std::string& name, Utime utime, const Robot& robot,
                 const ImportCloudsOptions& options) {
  CloudNotes notes;
  Sweep sweep;
  sweep.name = name;
  sweep.utime = utime;
  sweep.cloud = read_scan(file, &notes);
  sweep.sensor_height_m = options.sensor_height_m;
  const std::size_t near = drop_near_points(sweep.cloud, robot.laser.min_range_m);
  if (sweep.cloud.empty()) {
    throw InputError(printable(file) +
                     ": all of its points are nearer than the robot's min_range_m; correct that, or " +
                     "export the cloud with the sensor at its origin, in metres");
  }
  const auto level = notes.not_finite > 0 ? spdlog::level::warn : spdlog::level::info;
  if (!notes.sentence().empty()) spdlog::log(level, "{}: {}", printable(file), notes.sentence());
  if (near > 0) {
    spdlog::info("{}: left out {} points nearer than {} m", printable(file), near, robot.laser.min_range_m);
  }
  return sweep;
}

/// R as a tracker would give it: its heading is off about the world's z, its roll and pitch about the world's x and y.
Eigen::Quaterniond disturbed(const Eigen::Matrix3d& R_world_scan, const ImportCloudsOptions& options, Random& random) {
  const double heading = options.heading_sigma_deg * kRadiansPerDegree * random.normal();
  const double roll = options.tilt_sigma_deg * kRadiansPerDegree * random.normal();
  const double pitch = options.tilt_sigma_deg * kRadiansPerDegree * random.normal();
  const Eigen::Matrix3d R_tilt = exp_so3(Eigen::Vector3d(roll, pitch, 0.0));
  const Eigen::Matrix3d R_measured = rotation_about_z(heading) * R_tilt * nearest_rotation(R_world_scan);
  return Eigen::Quaterniond(R_measured).normalized();
}

reference_pose_t reference_message(Utime utime, const std::string& name, const Pose& X_ref_scan) {
  reference_pose_t message{};
  message.utime = utime;
  message.scan_name = name;
  for (int i = 0; i < 12; ++i) message.T_ref_scan[i] = X_ref_scan.matrix()(i / 4, i % 4);
  return message;
}

/// Writes what all scans share, then one scan after the other.
class ImportedLog {
 public:
  explicit ImportedLog(const std::string& path) : log_(path), bus_(log_) {}

  void write_start(const Robot& robot, const ImportCloudsOptions& options) {
    const std::vector<std::uint8_t> params = encode(params_message(kLogBegins, robot_text(robot)));
    publish_object(bus_, channel::kParams, params, kParamsKey, 1, kLogBegins, kBetweenPieces);
    if (!options.goal_m) return;
    const Utime utime = kLogBegins + kGoalAfterBegin;
    const Eigen::Vector2d goal(options.goal_m->first, options.goal_m->second);
    publish(channel::kGoal, goal_message(utime, goal), utime);
  }

  /// When the next scan is measured.
  Utime next_scan() const { return next_scan_; }

  void write_orientation(const Eigen::Quaterniond& R_world_sweep) {
    const Utime utime = next_scan_ - kImuBeforeSweep;
    publish(channel::kImu, imu_message(utime, R_world_sweep), utime);
  }

  void write_reference(const std::string& name, const Pose& X_ref_scan) {
    publish(channel::kReferencePose, reference_message(next_scan_, name, X_ref_scan), next_scan_);
  }

  void write_sweep(const Sweep& sweep) {
    const std::int64_t before = log_.events();
    publish_object(bus_, channel::kSweep, encode(sweep), sweep.name, ++sweeps_, sweep.utime, kBetweenPieces);
    const Utime pieces_end = sweep.utime + (log_.events() - before) * kBetweenPieces;
    next_scan_ = std::max(sweep.utime + kBetweenScans, pieces_end + 2 * kImuBeforeSweep);
  }

  void close() { log_.close(); }

 private:
  template <class Message>
  void publish(const Channel& channel, const Message& message, Utime utime) {
    bus_.publish(channel.name, encode(message), utime);
  }

  LogWriter log_;
  LogBus bus_;
  Utime next_scan_ = kLogBegins + kFirstScanAfterBegin;
  std::int64_t sweeps_ = 0;
};

}  // namespace

int run_import_clouds(const ImportCloudsOptions& options) {
  check(options);
  const std::vector<std::string> names = names_of(options.files);
  const std::string& poses_path = options.poses.empty() ? options.orientation : options.poses;
  const PosesFile poses = poses_path.empty() ? PosesFile{} : PosesFile::read(poses_path);
  if (!poses_path.empty()) {
    for (const std::string& name : names) poses.pose_of(name);  // A missing line is said before the long work.
  }
  const Robot robot = options.robot.empty() ? Robot{} : load_robot(options.robot);
  Random random(options.seed);
  ImportedLog log(options.output);
  log.write_start(robot, options);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Sweep sweep = read_sweep(options.files[k], names[k], log.next_scan(), robot, options);
    if (!poses_path.empty()) {
      log.write_orientation(disturbed(poses.pose_of(names[k]).linear(), options, random));
    }
    if (!options.poses.empty()) log.write_reference(names[k], poses.pose_of(names[k]));
    log.write_sweep(sweep);
  }
  log.close();
  return 0;
}

}  // namespace scanway::tools
