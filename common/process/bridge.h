#pragma once

#include <spdlog/spdlog.h>

#include <functional>
#include <string>
#include <vector>

#include "common/files/printable.h"
#include "common/process/program.h"

namespace scanway {

/// What every bridge is told on its command line, beside the options of its own.
struct BridgeOptions {
  std::string robot;    ///< Robot file; empty: the built-in ERA-Mobi.
  std::string lcm_url;  ///< Empty: LCM_DEFAULT_URL, or LCM's default.
  bool probe = false;   ///< Try the device without the bus, say what was found, end.
};

/// main() of the bridge to a device (run_main).
int run_bridge(const std::string& name, const std::string& purpose, int argc, char** argv,
               const std::function<void(CLI::App&)>& add_own_options,
               const std::function<int(const BridgeOptions&)>& work);

/// Prints what a probe found; the program's status: 0 if the device works, else 1.
int tell_probe(const std::vector<std::string>& lines, bool works);

/// What a program does for the node of its bridge, all in one thread.
struct BridgeWork {
  /// Waits at most so many milliseconds for the device, and publishes what came.
  std::function<void(int)> run_device;
  std::function<void()> every_second;
};

/// Lets a bridge serve its device, and the bus between, until the process is asked to end. What the device says is
/// published at once; what the bus says waits for at most 10 ms.
void serve_device(LiveBus& bus, const BridgeWork& work);

/// The same for a node that has its device within: what run() found amiss, and the device's welcome, go into the log.
template <class Node>
void serve_device(LiveBus& bus, Node& node) {
  const auto turn = [&node](int wait_ms) {
    for (const std::string& trouble : node.run(wait_ms)) spdlog::warn("{}", printable(trouble));
    if (const std::string welcome = node.take_welcome(); !welcome.empty()) spdlog::info("{}", printable(welcome));
  };
  serve_device(bus, BridgeWork{turn, [&bus, &node] { bus.report(node.counters(), node.summary()); }});
}

}  // namespace scanway
