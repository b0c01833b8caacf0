/// scanway-xsens: the bridge of an Xsens orientation tracker on LCM's bus.

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "common/process/bridge.h"
#include "common/process/process_bus.h"
#include "modules/xsens_bridge/device/probe.h"
#include "modules/xsens_bridge/node/xsens_node.h"

namespace scanway::xsens {
namespace {

struct Options {
  TrackerAddress address;
  TrackerConfig tracker;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--port", options.address.port, "Serial port of the tracker")->capture_default_str();
  app.add_option("--baud", options.address.baud, "Its rate (default: found out)");
  app.add_option("--rate", options.tracker.rate_hz, "Measurements a second")
      ->check(CLI::Range(1, 400))
      ->capture_default_str();
}

int probe(const Options& options) {
  const ProbeResult result = probe_tracker(options.address, options.tracker);
  return tell_probe(result.lines, result.works);
}

int run(const BridgeOptions& bridge, const Options& options) {
  const Robot::Tracker tracker = robot_of(bridge.robot).tracker;
  if (bridge.probe) return probe(options);
  ProcessBus process(bridge.lcm_url, this_process("xsens_bridge"));
  LiveBus& bus = process.live();
  TrackerDevice device(options.address, options.tracker, accuracy_of(tracker));
  XsensNode node(bus, device, tracker);
  process.start();
  spdlog::info("ready: {}", device.port());
  serve_device(bus, node);
  spdlog::info("ended");
  return 0;
}

}  // namespace
}  // namespace scanway::xsens

int main(int argc, char** argv) {
  scanway::xsens::Options options;
  return scanway::run_bridge(
      "scanway-xsens", "Orientation of an Xsens tracker on the bus", argc, argv,
      [&options](CLI::App& app) { scanway::xsens::add_options(app, options); },
      [&options](const scanway::BridgeOptions& bridge) { return scanway::xsens::run(bridge, options); });
}
