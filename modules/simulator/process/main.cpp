/// scanway-simulator: a robot in a world whose devices the bridges cannot tell from the real ones.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

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
#include "modules/simulator/process/console.h"
#include "scanway/reference_pose_t.hpp"

namespace scanway::simulator {
namespace {

struct Options {
  std::string world = "yard", pose, robot, lcm_url;
  std::uint64_t seed = 1;
  double speed = 1.0;
  bool host_time = false;
  int thin = 1;
  double slip = 0.02;
  std::vector<std::string> faults;
  DeviceEnds ends{2112, "unix:/tmp/scanway-can", "/tmp/scanway-tracker", "/tmp/scanway-base"};
};

std::string list_of_faults() {
  std::string list =
      "\nFaults, NAME[=VALUE][@SECONDS[+SECONDS]] (value, when, for how long), also as lines on stdin:\n";
  for (const FaultForm& form : fault_forms())
    list += fmt::format("  {:16} {} [{}]\n", form.name, form.what, form.value);
  return list;
}

void add_options(CLI::App& app, Options& options) {
  app.footer(list_of_faults());
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
  app.add_option("--slip", options.slip, "Share of the wheels' way that gets lost, on average")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--fault", options.faults, "What goes wrong, as in pan-stuck@10+5; again for more")
      ->type_name("FAULT");
  app.add_option("--robot", options.robot, "Robot file; without: the simulated ERA-Mobi");
  app.add_option("--lcm-url", options.lcm_url, "LCM's bus, for the truth alone");
}

World world_of(const Options& options) {
  try {
    return make_world(options.world, options.seed);
  } catch (const std::invalid_argument&) {
    throw InputError("--world " + in_quotes(options.world) + ": there is no such world; see scanway simulate worlds");
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
      throw InputError("--pose " + in_quotes(text) +
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

/// What is written to this process's input is a fault, from then on.
void hear_faults(Console& console, RobotInWorld& robot, Utime now) {
  while (const auto line = console.next_line()) {
    try {
      if (!line->empty()) robot.add_fault(parse_fault(*line, now));
    } catch (const InputError& error) {
      spdlog::warn("{}", error.what());
    }
  }
}

/// What people should know, once.
class News {
 public:
  void tell(RobotInWorld& robot) {
    for (const std::string& line : robot.take_news()) spdlog::info("fault {}", line);
    if (robot.obstacle() != obstacle_) {
      obstacle_ = robot.obstacle();
      if (!obstacle_.empty()) spdlog::warn("the robot is held: it would stand {}", obstacle_);
    }
    if (robot.dropped_scans() == dropped_ || steady_now() < tell_again_) return;
    spdlog::warn("this machine is too slow for --speed: the laser has dropped {} scans", robot.dropped_scans());
    dropped_ = robot.dropped_scans();
    tell_again_ = steady_now() + kSteadySecond;
  }

 private:
  std::string obstacle_;
  std::int64_t dropped_ = 0;
  SteadyTime tell_again_ = 0;
};

/// Lives until it is asked to end.
void live(RobotInWorld& robot, LcmBus& bus, double speed) {
  const SteadyTime began = steady_now();
  Console console;
  News news;
  for (SteadyTime truth_due = began; !asked_to_end();) {
    robot.wait(1);
    const SteadyTime now = steady_now();
    const Utime clock = std::llround(static_cast<double>(now - began) * speed);
    hear_faults(console, robot, clock);
    robot.run(clock);
    news.tell(robot);
    if (now < truth_due) continue;
    truth_due = now + kMicrosecondsPerSecond;
    publish_truth(bus, robot);
  }
}

int run(const Options& options) {
  const World world = world_of(options);
  const Robot robot = options.robot.empty() ? simulated_robot() : load_robot(options.robot);
  const Place place = place_of(options.pose, world);
  const Stand stand = stand_at(world, robot, place);
  if (!stand.problem.empty()) throw InputError("--pose: the robot would stand " + stand.problem);
  LcmBus bus(lcm_url(options.lcm_url));
  RobotInWorld simulated(world, robot, stand, options.seed, options.thin, options.ends);
  simulated.add_fault({FaultKind::slip, options.slip, 0, Fault::kNever});
  for (const std::string& fault : options.faults) simulated.add_fault(parse_fault(fault, 0));
  if (options.host_time) simulated.tell_host_time(options.speed);
  fmt::print("laser    127.0.0.1:{}\npan-tilt {}\ntracker  {}\nbase     {}\n", simulated.lms_port(), options.ends.can,
             options.ends.tracker, options.ends.base);
  fmt::print("stands   {:.3f},{:.3f},{:.3f} in {} {}\n", place.x, place.y, place.heading, options.world, options.seed);
  std::fflush(stdout);

  live(simulated, bus, options.speed);
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
