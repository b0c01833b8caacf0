#include "modules/tools/simulate/simulate_places.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "bot_core/pose_t.hpp"
#include "common/bus/channels.h"
#include "common/bus/lcm_bus.h"
#include "common/bus/lcm_url.h"
#include "common/clock/steady_time.h"
#include "common/files/input_error.h"
#include "common/messages/codec.h"
#include "common/messages/pose_message.h"
#include "common/messages/rigid.h"
#include "modules/simulator/core/world/world.h"
#include "modules/tools/simulate/simulated_world.h"
#include "scanway/reference_pose_t.hpp"

namespace scanway::tools {
namespace {

using namespace scanway::simulator;

/// Truth and pose are said once a second; a mapper at work may be silent for a while.
constexpr SteadyTime kPatience = 60'000'000;
constexpr auto kWait = std::chrono::milliseconds(20);

/// The world in the map, by where the robot stands in both.
Pose hear_X_map_world(const std::string& url) {
  std::optional<Pose> X_world_base, X_map_base;
  LcmBus bus(lcm_url(url));
  bus.subscribe(channel::kReferencePose.name, [&](const BusMessage& message) {
    X_world_base = get_rows(decode<reference_pose_t>(message.bytes).T_ref_scan);
  });
  bus.subscribe(channel::kPose.name,
                [&](const BusMessage& message) { X_map_base = pose_of(decode<bot_core::pose_t>(message.bytes)); });
  for (const SteadyTime end = steady_now() + kPatience; !X_world_base || !X_map_base;) {
    bus.dispatch(kWait);
    if (steady_now() < end) continue;
    throw InputError(X_world_base ? "no POSE is heard on this bus: start scanway-mapper and take a sweep"
                                  : "no scanway-simulator is heard on this bus: start it, or leave out --in-map");
  }
  return *X_map_base * X_world_base->inverse();
}

}  // namespace

int run_simulate_places(const SimulatePlacesOptions& options) {
  const World world = world_of(options.world, options.seed);
  const Pose X = options.in_map ? hear_X_map_world(options.lcm_url) : Pose::Identity();
  for (const Place& place : places_on_route(world, options.count, options.spacing_m)) {
    const Eigen::Vector3d at = X * Eigen::Vector3d(place.x, place.y, 0.0);
    fmt::print("{:.3f},{:.3f},{:.4f}\n", at.x(), at.y(), heading_of(X.linear() * rotation_about_z(place.heading)));
  }
  return 0;
}

}  // namespace scanway::tools
