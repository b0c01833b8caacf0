#include "common/process/bridge.h"

#include <CLI/CLI.hpp>
#include <cstdio>

namespace scanway {
namespace {

constexpr int kDeviceWaitMs = 10;

}  // namespace

int run_bridge(const std::string& name, const std::string& purpose, int argc, char** argv,
               const std::function<void(CLI::App&)>& add_own_options,
               const std::function<int(const BridgeOptions&)>& work) {
  BridgeOptions options;
  const auto add_options = [&](CLI::App& app) {
    app.add_option("--robot", options.robot, "Robot file (default: ERA-Mobi)");
    app.add_option("--lcm-url", options.lcm_url, "The bus (default: LCM_DEFAULT_URL, or multicast on this machine)");
    app.add_flag("--probe", options.probe, "Try the device without the bus, say what was found, and end");
    add_own_options(app);
  };
  return run_main(name, purpose, argc, argv, add_options, [&options, &work] { return work(options); });
}

int tell_probe(const std::vector<std::string>& lines, bool works) {
  for (const std::string& line : lines) std::puts(printable(line).c_str());
  return works ? 0 : 1;
}

void serve_device(LiveBus& bus, const BridgeWork& work) {
  SteadyTime next_second = 0;
  while (!asked_to_end()) {
    work.run_device(kDeviceWaitMs);
    bus.dispatch(std::chrono::milliseconds(0));
    const SteadyTime now = steady_now();
    if (now < next_second) continue;
    work.every_second();
    next_second = now + kSteadySecond;
  }
}

}  // namespace scanway
