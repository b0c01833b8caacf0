/// scanway-xsens: the bridge of an Xsens orientation tracker on LCM's bus.

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "common/bus/lcm_url.h"
#include "common/files/printable.h"
#include "common/process/bridge.h"
#include "modules/xsens_bridge/device/probe.h"
#include "modules/xsens_bridge/node/xsens_node.h"

namespace scanway::xsens {
namespace {

constexpr auto kListenForTwins = std::chrono::milliseconds(1500);

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
  LcmBus lcm(lcm_url(bridge.lcm_url));
  if (!lcm.advice().empty()) spdlog::warn("{}", lcm.advice());
  LiveBus bus(lcm, this_process("xsens_bridge"));
  TrackerDevice device(options.address, options.tracker, accuracy_of(tracker));
  XsensNode node(bus, device, tracker);
  bus.start();
  bus.refuse_twins(kListenForTwins);
  spdlog::info("ready: {}", device.port());
  const auto turn = [&node](int wait_ms) {
    for (const std::string& trouble : node.run(wait_ms)) spdlog::warn("{}", printable(trouble));
    if (const std::string welcome = node.take_welcome(); !welcome.empty()) spdlog::info("{}", printable(welcome));
  };
  serve_device(bus, {turn, [&bus, &node] { bus.report(node.counters(), node.summary()); }});
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
