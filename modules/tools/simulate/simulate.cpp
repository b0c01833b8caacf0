#include "modules/tools/simulate/simulate.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "common/bus/log_bus.h"
#include "common/bus/log_writer.h"
#include "common/cloud/read_cloud.h"
#include "common/config/robot_file.h"
#include "common/files/atomic_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/grid/map_file.h"
#include "common/messages/codec.h"
#include "common/messages/objects.h"
#include "common/messages/params_message.h"
#include "modules/simulator/core/simulator.h"
#include "modules/simulator/files/labelled_pcd.h"
#include "modules/simulator/node/raw_log.h"
#include "modules/tools/simulate/simulated_world.h"
#include "scanway/reference_pose_t.hpp"

namespace scanway::tools {
namespace {

using namespace scanway::simulator;

constexpr Utime kLogBegins = 946'684'800 * kMicrosecondsPerSecond;  // As the logs of `scanway import` do.
constexpr Utime kFirstSweepAfterBegin = 3 * kMicrosecondsPerSecond;
constexpr Utime kBetweenSweeps = 20 * kMicrosecondsPerSecond;

Robot robot_of(const std::string& file) { return file.empty() ? simulated_robot() : load_robot(file); }

Place place_of(const std::string& text) {
  double values[3] = {};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto [next, error] = std::from_chars(at, end, values[i]);
    const bool separated = i == 2 ? next == end : next != end && *next == ',';
    if (error != std::errc{} || !separated || !(std::fabs(values[i]) < 1e6)) {
      throw InputError("--pose " + in_quotes(text) +
                       ": not x,y,yaw; give metres, metres and radians, as in 2.5,-1,0.3");
    }
    at = next + 1;
  }
  return {values[0], values[1], values[2]};
}

/// The robot at the place, or an error that says where in this world it can stand.
Stand stand_or_refuse(const World& world, const Robot& robot, const std::string& pose) {
  Stand stand = stand_at(world, robot, place_of(pose));
  if (stand.problem.empty()) return stand;
  for (const Place& place : places_on_route(world, 20)) {
    if (!stand_at(world, robot, place).problem.empty()) continue;
    throw InputError(
        fmt::format("--pose {}: the robot would stand {}; a free place in this world is {:.2f},{:.2f},{:.2f}",
                    in_quotes(pose), stand.problem, place.x, place.y, place.heading));
  }
  throw InputError("--pose " + in_quotes(pose) + ": the robot would stand " + stand.problem + "; choose another place");
}

/// A line of a poses file (common/cloud/poses_file.h).
std::string pose_line(const std::string& name, const Pose& X) {
  std::string line = name;
  for (int i = 0; i < 12; ++i) line += fmt::format(" {}", X.matrix()(i / 4, i % 4));
  return line + '\n';
}

/// The exact poses and the tracker's orientations, beside the output.
class PoseFiles {
 public:
  void add(const std::string& name, const Pose& X_world_base, const Tracker& tracker) {
    Pose measured = Pose::Identity();
    measured.linear() = tracker.mean().toRotationMatrix();
    poses_ += pose_line(name, X_world_base);
    orientations_ += pose_line(name, measured);
  }
  void write(const std::string& output) const {
    write_file(output + ".pose", poses_);
    write_file(output + ".orientation", orientations_);
  }

 private:
  std::string poses_, orientations_;
};

void write_params(Bus& bus, const Robot& robot) {
  publish_object(bus, channel::kParams, encode(params_message(kLogBegins, robot_text(robot))), kParamsKey, 1,
                 kLogBegins);
}

void write_reference(Bus& bus, const std::string& name, const Pose& X_world_base, Utime utime) {
  reference_pose_t message{};
  message.utime = utime;
  message.scan_name = name;
  for (int i = 0; i < 12; ++i) message.T_ref_scan[i] = X_world_base.matrix()(i / 4, i % 4);
  bus.publish(channel::kReferencePose.name, encode(message), utime);
}

/// Every pose is another sweep with random numbers of its own.
SweepConfig config_of(const SimulateSweepOptions& options, std::size_t sweep) {
  SweepConfig config;
  config.seed = options.seed + 0x9E3779B97F4A7C15U * sweep;
  config.thin = options.thin;
  config.people = options.people;
  config.start = kLogBegins + kFirstSweepAfterBegin;
  return config;
}

void write_cloud(const SimulateSweepOptions& options, const World& world, const Robot& robot) {
  const Stand stand = stand_or_refuse(world, robot, options.poses[0]);
  const SweepConfig config = config_of(options, 0);
  const RawSweep raw = simulate_lines(world, robot, stand.X_world_base, config);
  const LabelledSweep points = points_of(raw, robot, options.body);
  write_labelled_pcd(options.output, points);
  PoseFiles poses;
  poses.add(scan_name(options.output), stand.X_world_base, Tracker(robot.tracker, stand.X_world_base, config.seed));
  poses.write(options.output);
  spdlog::info("{}: {} points of {} beams", printable(options.output), points.labels.size(), raw.readings.size());
}

void write_log(const SimulateSweepOptions& options, const World& world, const Robot& robot) {
  std::vector<Stand> stands;
  for (const std::string& pose : options.poses) stands.push_back(stand_or_refuse(world, robot, pose));
  LogWriter log(options.output);
  LogBus bus(log);
  write_params(bus, robot);
  PoseFiles poses;
  SweepNumbers numbers{1, 0, kLogBegins};
  Utime start = kLogBegins + kFirstSweepAfterBegin;
  for (std::size_t i = 0; i < stands.size(); ++i, ++numbers.sweep) {
    const Pose& X_world_base = stands[i].X_world_base;
    const std::string name = "sweep_" + std::to_string(numbers.sweep);
    SweepConfig config = config_of(options, i);
    config.start = start;
    const Tracker tracker(robot.tracker, X_world_base, config.seed);
    const RawSweep raw = simulate_lines(world, robot, X_world_base, config);
    write_reference(bus, name, X_world_base, start - kMicrosecondsPerSecond);
    publish_raw_sweep(bus, raw, tracker, numbers);
    poses.add(name, X_world_base, tracker);
    numbers.first_line += raw.lines;
    start = raw.pattern.end() + kBetweenSweeps;
  }
  log.close();
  poses.write(options.output);
  spdlog::info("{}: {} messages", printable(options.output), log.events());
}

bool ends_with(const std::string& path, std::string_view ending) { return path.ends_with(ending); }

}  // namespace

int run_simulate_sweep(const SimulateSweepOptions& options) {
  const bool log = ends_with(options.output, ".lcm") || ends_with(options.output, ".lcmlog");
  if (!log && !ends_with(options.output, ".pcd")) {
    throw InputError(printable(options.output) + ": name it *.pcd for a cloud, or *.lcm for a log of raw messages");
  }
  if (options.poses.empty()) throw InputError("simulate sweep: where does the robot stand? Give --pose x,y,yaw");
  if (!log && options.poses.size() > 1) {
    throw InputError("simulate sweep: a cloud holds one sweep; give one --pose, or write a log (*.lcm)");
  }
  const World world = world_of(options.world, options.seed);
  const Robot robot = robot_of(options.robot);
  if (log) {
    write_log(options, world, robot);
  } else {
    write_cloud(options, world, robot);
  }
  return 0;
}

int run_simulate_truth(const SimulateTruthOptions& options) {
  if (!ends_with(options.output, ".yaml")) {
    throw InputError(printable(options.output) + ": name it *.yaml; the picture goes beside it as *.pgm");
  }
  const World world = world_of(options.world, options.seed);
  const TruthGrid truth = make_truth(world, robot_of(options.robot).body, options.resolution_m);
  write_map(to_cost_map(truth), options.output);
  write_map(to_cost_map(truth, true), options.output.substr(0, options.output.size() - 5) + "_drop_off.yaml");
  const auto count = [&](CellTruth what) { return std::count(truth.cells.begin(), truth.cells.end(), what); };
  spdlog::info("{}: {} cells free, {} occupied, {} on the edge of a drop", printable(options.output),
               count(CellTruth::free), count(CellTruth::occupied), count(CellTruth::drop_off));
  return 0;
}

int run_simulate_worlds() {
  for (const WorldKind& kind : world_kinds()) fmt::print("{:10} {}\n", kind.name, kind.what);
  return 0;
}

}  // namespace scanway::tools
