#include "common/process/process_bus.h"

#include <spdlog/spdlog.h>

#include "common/bus/lcm_url.h"

namespace scanway {
namespace {

constexpr auto kListenForTwins = std::chrono::milliseconds(1500);

}  // namespace

ProcessBus::ProcessBus(const std::string& url, const Identity& who, const LiveBusOptions& options)
    : lcm_(lcm_url(url)), live_(lcm_, who, options) {
  if (!lcm_.advice().empty()) spdlog::warn("{}", lcm_.advice());
}

void ProcessBus::start() {
  live_.start();
  live_.refuse_twins(kListenForTwins);
}

}  // namespace scanway
