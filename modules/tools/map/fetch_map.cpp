#include "modules/tools/map/fetch_map.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "common/bus/channels.h"
#include "common/bus/lcm_url.h"
#include "common/cloud/write_cloud.h"
#include "common/delivery/live_bus.h"
#include "common/files/saved_folder.h"
#include "common/grid/map_file.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "scanway/map_request_t.hpp"

namespace scanway::tools {
namespace {

constexpr int kNotWhole = 1;
constexpr auto kWait = std::chrono::milliseconds(20);

/// Requests take their share of a slow link too: few at a time, and with patience.
LiveBusOptions patient() {
  LiveBusOptions options;
  options.receiver.requests_a_turn = 3;
  options.receiver.quiet = kSteadySecond;
  options.receiver.first_interval = kSteadySecond;
  options.receiver.longest_interval = 4 * kSteadySecond;
  options.receiver.first = {std::string(channel::kCostMapIndex.name), std::string(channel::kMapLevel.name)};
  return options;
}

map_request_t request_of(const FetchMapOptions& options, const Identity& who) {
  map_request_t request{};
  request.utime = who.start;
  request.requester_name = who.text();
  request.cloud_voxel_m = options.detail.cloud_m;
  request.octomap_voxel_m = options.detail.octomap_m;
  return request;
}

void write_map(const MapCopy& copy, const FetchMapOptions& options) {
  FolderSave save(options.output);
  scanway::write_map(copy.cost_map(), save.files().path_of("costmap.yaml"));
  if (options.detail.cloud_m > 0.0) write_pcd(save.files().path_of("map.pcd"), copy.cloud());
  if (options.detail.octomap_m > 0.0) save.files().write("map.bt", copy.octomap());
  save.commit();
}

void say(double seconds, const std::string& what) {
  std::puts(fmt::format("{:.1f} s: {}", seconds, what).c_str());
  std::fflush(stdout);
}

}  // namespace

int run_fetch_map(const FetchMapOptions& options) {
  const ProductFolder folder(options.output);  // Said before the wait.
  const Identity who = this_process("fetch");
  LcmBus lcm(lcm_url(options.lcm_url));
  LiveBus bus(lcm, who, patient());
  MapCopy copy(bus, options.detail);
  bus.start();
  const SteadyTime begin = steady_now();
  const auto seconds = [begin] { return static_cast<double>(steady_now() - begin) / 1e6; };
  for (SteadyTime next = 0; !copy.is_whole();) {
    if (seconds() > options.limit_s) return say(seconds(), "not whole, given up: " + copy.state()), kNotWhole;
    if (steady_now() >= next) {
      bus.publish(channel::kMapRequest.name, encode(request_of(options, who)), 0);
      say(seconds(), copy.state());
      next = steady_now() + kSteadySecond;
    }
    bus.dispatch(kWait);
  }
  say(seconds(), "whole: " + copy.state() + "; digest " + hex(copy.cost_map_digest()));
  write_map(copy, options);
  return 0;
}

}  // namespace scanway::tools
