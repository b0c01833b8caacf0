/// scanway-schunk: the bridge between the pan-tilt on a CAN bus and LCM's bus.

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "common/bus/channels.h"
#include "common/clock/host_time.h"
#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/process/bridge.h"
#include "common/process/process_bus.h"
#include "modules/schunk_bridge/device/pan_tilt_driver.h"
#include "modules/schunk_bridge/node/pan_tilt_node.h"

namespace scanway::schunk {
namespace {
/// What the bus says waits for the device's turn at the most: stops must not wait.
constexpr int kLongestTurnMs = 4;
/// Until a stop is on its way and answered.
constexpr Utime kLastWords = 200'000;

struct Options {
  std::string can = "can0";
  int pan_id = 11, tilt_id = 12;
  double tilt_deg = 0;
  bool position_only = false;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--can", options.can, "CAN interface, or unix:/path of a program that pretends one")
      ->capture_default_str();
  app.add_option("--pan-id", options.pan_id, "Id of the pan's module")
      ->check(CLI::Range(1, 255))
      ->capture_default_str();
  app.add_option("--tilt-id", options.tilt_id, "Id of the tilt's module")
      ->check(CLI::Range(1, 255))
      ->capture_default_str();
  app.add_option("--tilt-deg", options.tilt_deg, "Tilt that sweeps hold")->check(CLI::Range(-120.0, 120.0));
  app.add_flag("--position-only", options.position_only, "Ask for states without velocity: one frame instead of two");
}

PanTiltConfig config_of(const Options& options, const Robot& robot) {
  PanTiltConfig config;
  if (options.pan_id == options.tilt_id)
    throw InputError("--pan-id and --tilt-id are the same; each module has its own");
  config.pan.module = static_cast<std::uint8_t>(options.pan_id);
  config.tilt.module = static_cast<std::uint8_t>(options.tilt_id);
  config.pan.ask_velocity = config.tilt.ask_velocity = !options.position_only;
  config.sweep.speed = robot.pan.speed_rad_s;
  config.sweep.angle = robot.pan.sweep;
  config.sweep.start = -robot.pan.sweep / 2;
  config.sweep.tilt = options.tilt_deg * radians(1.0L);
  return config;
}

void report(LiveBus& bus, const PanTiltDriver& driver, const PanTiltNode& node) {
  const BusCounters& can = driver.counters();
  const auto count = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
  auto counters = node.counters();
  counters["schunk_times_opened"] = count(can.times_opened);
  counters["schunk_error_frames"] = count(can.error_frames);
  counters["schunk_frame_losses"] = count(can.losses);
  counters["schunk_times_full"] = count(can.times_full);
  std::string summary = driver.trouble();
  if (const std::string more = node.summary(host_now()); !more.empty()) summary += (summary.empty() ? "" : "; ") + more;
  bus.report(counters, summary);
}

int run(const BridgeOptions& bridge, const Options& options) {
  const Robot robot = bridge.robot.empty() ? Robot{} : load_robot(bridge.robot);
  const PanTiltConfig config = config_of(options, robot);
  if (bridge.probe) {
    const ProbeResult result = probe(options.can, config);
    return tell_probe(result.lines, result.works);
  }
  const Identity who = this_process("schunk_bridge");
  LiveBusOptions live;
  live.repeated = {std::string(channel::kSweepMark.name)};
  ProcessBus process(bridge.lcm_url, who, live);
  LiveBus& bus = process.live();
  PanTiltDriver driver(options.can, config);
  PanTiltNode node(bus, driver.core(), who.start);
  process.start();
  if (is_pretended_can(options.can)) spdlog::warn("{}: not a CAN bus, but a program that pretends one", options.can);
  spdlog::info("ready");

  const auto turn = [&](int timeout_ms) {
    if (node.obey(host_now())) report(bus, driver, node);
    driver.step(std::min(timeout_ms, kLongestTurnMs));
    for (const std::string& line : driver.take_troubles()) spdlog::warn("{}", line);
    node.tell(host_now());
  };
  serve_device(bus, {turn, [&] { report(bus, driver, node); }});
  if (node.stop_moving(host_now())) {
    for (const Utime end = host_now() + kLastWords; host_now() < end;) turn(10);
  }
  spdlog::info("ended");
  return 0;
}

}  // namespace
}  // namespace scanway::schunk

int main(int argc, char** argv) {
  scanway::schunk::Options options;
  return scanway::run_bridge(
      "scanway-schunk", "The pan-tilt (SCHUNK PW-70) on a CAN bus", argc, argv,
      [&options](CLI::App& app) { scanway::schunk::add_options(app, options); },
      [&options](const scanway::BridgeOptions& bridge) { return scanway::schunk::run(bridge, options); });
}
