/// scanway-link: from the robot's bus to one behind a slow link, and back.

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "common/bus/channels.h"
#include "common/process/process_bus.h"
#include "common/process/program.h"
#include "modules/link/node/link_node.h"

namespace scanway {
namespace {

constexpr auto kWait = std::chrono::milliseconds(10);
constexpr double kBytesPerMbit = 125e3;

struct LinkOptions {
  std::string near_url, far_url;
  double rate_mbit_s = 1.7;
};

/// On a slow link what is announced takes its share too.
LiveBusOptions far_options(const LinkOptions& options) {
  LiveBusOptions far;
  far.sender.bytes_per_second = options.rate_mbit_s * kBytesPerMbit;
  far.sender.burst_bytes = 4e3;
  far.sender.indices_a_turn = 8;
  far.sender.drop_superseded = true;
  far.sender.first = {std::string(channel::kCostMapIndex.name), std::string(channel::kMapLevel.name)};
  return far;
}

int run(const LinkOptions& options) {
  const Identity who = this_process("link");
  ProcessBus near(options.near_url, who), far(options.far_url, who, far_options(options));
  LinkNode node(near.live(), far.live());
  near.start();
  far.start();
  spdlog::info("ready: {:.1f} Mbit/s over the link", options.rate_mbit_s);
  for (SteadyTime next = 0; !asked_to_end();) {
    near.live().dispatch(kWait);
    far.live().dispatch(kWait);
    if (steady_now() < next) continue;
    next = steady_now() + kSteadySecond;
    node.every_second(steady_now());
    near.live().report(node.counters(), "");
    far.live().report(node.counters(), "");
  }
  return 0;
}

}  // namespace
}  // namespace scanway

int main(int argc, char** argv) {
  scanway::LinkOptions options;
  return scanway::run_main(
      "scanway-link", "The robot's bus over a slow link: the cost map, and of cloud and OctoMap what is asked for",
      argc, argv,
      [&options](CLI::App& app) {
        app.add_option("--near", options.near_url, "The robot's bus")->required();
        app.add_option("--far", options.far_url, "The bus behind the link; another port than the robot's")->required();
        app.add_option("--rate-mbit-s", options.rate_mbit_s, "The most that the map may take of the link")
            ->check(CLI::Range(0.01, 1000.0))
            ->capture_default_str();
      },
      [&options] { return scanway::run(options); });
}
