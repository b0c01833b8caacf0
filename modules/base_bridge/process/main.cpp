/// scanway-base: the bridge between the ERA-Mobi base on a serial port and LCM's bus.

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "common/clock/host_time.h"
#include "common/config/robot_file.h"
#include "common/process/bridge.h"
#include "common/process/process_bus.h"
#include "modules/base_bridge/device/base_driver.h"
#include "modules/base_bridge/node/base_node.h"

namespace scanway::erratic {
namespace {

void report(LiveBus& bus, const BaseDriver& driver, const BaseNode& node) {
  auto counters = node.counters();
  counters["base_times_opened"] = static_cast<std::int64_t>(driver.times_opened());
  bus.report(counters, driver.connected() ? node.summary(host_now()) : driver.trouble());
}

int run(const BridgeOptions& bridge, const std::string& port) {
  const Robot robot = bridge.robot.empty() ? Robot{} : load_robot(bridge.robot);
  if (bridge.probe) {
    const ProbeResult result = probe(port);
    return tell_probe(result.lines, result.works);
  }
  ProcessBus process(bridge.lcm_url, this_process("base_bridge"));
  LiveBus& bus = process.live();
  BaseConfig config;
  config.drive.max_speed_m_s = robot.body.max_speed_m_s;
  config.drive.max_turn_rate_rad_s = robot.body.max_turn_rate;
  BaseDriver driver(port, config);
  BaseNode node(bus, driver.core());
  process.start();
  spdlog::info("ready");

  const auto turn = [&](int timeout_ms) {
    node.obey(host_now());
    driver.step(timeout_ms);
    for (const std::string& line : driver.take_troubles()) spdlog::warn("{}", line);
    node.tell();
  };
  serve_device(bus, {turn, [&] { report(bus, driver, node); }});
  spdlog::info("ended");
  return 0;  // The driver leaves the robot standing.
}

}  // namespace
}  // namespace scanway::erratic

int main(int argc, char** argv) {
  std::string port = "/dev/erratic";
  return scanway::run_bridge(
      "scanway-base", "The robot's base (ERA-Mobi) on a serial port", argc, argv,
      [&port](CLI::App& app) {
        app.add_option("--port", port, "Serial port, best by its name below /dev/serial/by-id")->capture_default_str();
      },
      [&port](const scanway::BridgeOptions& bridge) { return scanway::erratic::run(bridge, port); });
}
