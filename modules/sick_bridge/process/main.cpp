/// scanway-sick: the bridge of a SICK LMS5xx on LCM's bus.

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "common/process/bridge.h"
#include "common/process/process_bus.h"
#include "modules/sick_bridge/device/probe.h"
#include "modules/sick_bridge/node/lms_options.h"
#include "modules/sick_bridge/node/sick_node.h"

namespace scanway::sick {
namespace {

constexpr double kBytesPerMbit = 125e3;

struct Options {
  LmsAddress address;
  LmsOptions lms;
  SickOptions node;
  bool no_laser_scan = false;
  double resend_mbit_s = 4.0;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--host", options.address.host, "Name or address of the scanner")->capture_default_str();
  app.add_option("--port", options.address.port, "2112 or 2111; the dialect is found out")->capture_default_str();
  app.add_option("--frequency", options.lms.frequency_hz, "Turns of the mirror a second (default: the robot file's)");
  app.add_option("--resolution", options.lms.resolution_deg, "Degrees between beams (default: the robot file's)");
  app.add_option("--sector", options.lms.sector_deg, "First and last angle that is sent, degrees (default: all)");
  app.add_option("--echo", options.lms.echo, "Which returns: first, last or all")->capture_default_str();
  app.add_option("--rssi", options.lms.rssi_bits, "Bits of remission: 0 (none), 8 or 16")->capture_default_str();
  app.add_flag("--store", options.lms.store, "Keep the settings in the scanner when its power goes");
  app.add_flag("--no-laser-scan", options.no_laser_scan, "No LASER_SCAN, which only LCM's own tools read");
  app.add_flag("--raw", options.node.raw, "Every telegram as it came, on LASER_RAW");
  app.add_option("--resend-mbit-s", options.resend_mbit_s, "The most that lines sent again may take of the network")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
}

int probe(const LmsAddress& address, const LmsConfig& config) {
  const ProbeResult result = probe_lms(address, config);
  return tell_probe(result.lines, result.works);
}

int run(const BridgeOptions& bridge, Options& options) {
  const LmsConfig config = lms_config(options.lms, robot_of(bridge.robot).laser);
  if (bridge.probe) return probe(options.address, config);
  const Identity who = this_process("sick_bridge");
  ProcessBus process(bridge.lcm_url, who);
  LiveBus& bus = process.live();
  LmsDevice device(options.address, config);
  options.node.laser_scan = !options.no_laser_scan;
  options.node.archive.bytes_per_second = options.resend_mbit_s * kBytesPerMbit;
  SickNode node(bus, device, who.start, options.node);
  process.start();
  spdlog::info("ready: {}", device.name());
  serve_device(bus, node);
  spdlog::info("ended");
  return 0;
}

}  // namespace
}  // namespace scanway::sick

int main(int argc, char** argv) {
  scanway::sick::Options options;
  return scanway::run_bridge(
      "scanway-sick", "Lines of a SICK LMS5xx on the bus", argc, argv,
      [&options](CLI::App& app) { scanway::sick::add_options(app, options); },
      [&options](const scanway::BridgeOptions& bridge) { return scanway::sick::run(bridge, options); });
}
