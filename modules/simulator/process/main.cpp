/// scanway-simulator: a robot in a world whose devices the bridges cannot tell from the real ones.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <string>

#include "common/bus/channels.h"
#include "common/bus/lcm_bus.h"
#include "common/bus/lcm_url.h"
#include "common/clock/host_time.h"
#include "common/clock/steady_time.h"
#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/messages/codec.h"
#include "common/process/program.h"
#include "modules/simulator/device/robot/robot_in_world.h"
#include "scanway/reference_pose_t.hpp"

namespace scanway::simulator {
namespace {

struct Options {
  std::string world = "yard", pose, robot, lcm_url;
  std::uint64_t seed = 1;
  double speed = 1.0;
  bool host_time = false;
  int thin = 1;
  DeviceEnds ends{2112, "unix:/tmp/scanway-can", "/tmp/scanway-tracker", "/tmp/scanway-base"};
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--world", options.world, "World (scanway simulate worlds)")->capture_default_str();
  app.add_option("--seed", options.seed, "Of the world and of all noise")->capture_default_str();
  app.add_option("--pose", options.pose, "x,y,yaw: metres and radians; without: the first place of the world's route");
  app.add_option("--speed", options.speed, "Seconds of the devices' clocks in one of this machine's")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
  app.add_flag("--host-time", options.host_time,
               "At another speed than 1, laser and tracker tell times and rates by this machine's clock");
  app.add_option("--thin", options.thin, "Only every K-th line, and of it every K-th beam, sees anything")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--lms-port", options.ends.lms_port, "The laser's TCP port; 0: any free one")->capture_default_str();
  app.add_option("--can", options.ends.can, "The pan-tilt's CAN interface, or unix:/path for a pretended one")
      ->capture_default_str();
  app.add_option("--tracker", options.ends.tracker, "Link to the tracker's terminal")->capture_default_str();
  app.add_option("--base", options.ends.base, "Link to the base's terminal")->capture_default_str();
  app.add_option("--robot", options.robot, "Robot file; without: the simulated ERA-Mobi");
  app.add_option("--lcm-url", options.lcm_url, "LCM's bus, for the truth alone");
}

World world_of(const Options& options) {
  try {
    return make_world(options.world, options.seed);
  } catch (const std::invalid_argument&) {
    throw InputError("--world " + scanway::quoted(options.world) +
                     ": there is no such world; see scanway simulate worlds");
  }
}

Place place_of(const std::string& text, const World& world) {
  if (text.empty()) return places_on_route(world, 1).at(0);
  double values[3] = {};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (double& value : values) {
    const auto [next, error] = std::from_chars(at, end, value);
    const bool last = &value == &values[2];
    if (error != std::errc{} || (last ? next != end : next == end || *next != ',') || !(std::fabs(value) < 1e6)) {
      throw InputError("--pose " + scanway::quoted(text) +
                       ": not x,y,yaw; give metres, metres and radians, as in 2.5,-1,0.3");
    }
    at = next + (last ? 0 : 1);
  }
  return {values[0], values[1], values[2]};
}

/// REFERENCE_POSE: no process of the robot reads it.
void publish_truth(LcmBus& bus, const RobotInWorld& robot) {
  reference_pose_t message{};
  message.utime = host_now();
  message.scan_name = "simulator";
  for (int i = 0; i < 12; ++i) message.T_ref_scan[i] = robot.X_world_base().matrix()(i / 4, i % 4);
  bus.publish(channel::kReferencePose.name, encode(message), message.utime);
}

int run(const Options& options) {
  const World world = world_of(options);
  const Robot robot = options.robot.empty() ? simulated_robot() : load_robot(options.robot);
  const Place place = place_of(options.pose, world);
  const Stand stand = stand_at(world, robot, place);
  if (!stand.problem.empty()) throw InputError("--pose: the robot would stand " + stand.problem);
  LcmBus bus(lcm_url(options.lcm_url));
  RobotInWorld simulated(world, robot, stand, options.seed, options.thin, options.ends);
  if (options.host_time) simulated.tell_host_time(options.speed);
  fmt::print("laser    127.0.0.1:{}\npan-tilt {}\ntracker  {}\nbase     {}\n", simulated.lms_port(), options.ends.can,
             options.ends.tracker, options.ends.base);
  fmt::print("stands   {:.3f},{:.3f},{:.3f} in {} {}\n", place.x, place.y, place.heading, options.world, options.seed);
  std::fflush(stdout);

  const SteadyTime began = steady_now();
  std::string problem;
  for (SteadyTime truth_due = began; !asked_to_end();) {
    const SteadyTime now = steady_now();
    simulated.run(std::llround(static_cast<double>(now - began) * options.speed), 1);
    if (simulated.problem() != problem) {
      problem = simulated.problem();
      if (!problem.empty()) spdlog::warn("the robot stands {}", problem);
    }
    if (now < truth_due) continue;
    truth_due = now + kMicrosecondsPerSecond;
    publish_truth(bus, simulated);
  }
  return 0;
}

}  // namespace
}  // namespace scanway::simulator

int main(int argc, char** argv) {
  scanway::simulator::Options options;
  return scanway::run_main(
      "scanway-simulator", "A robot in a world, with its four devices", argc, argv,
      [&options](CLI::App& app) { scanway::simulator::add_options(app, options); },
      [&options] { return scanway::simulator::run(options); });
}
