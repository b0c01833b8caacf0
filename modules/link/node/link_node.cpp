#include "modules/link/node/link_node.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "common/files/input_error.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "common/messages/objects.h"
#include "common/octree/octree_file.h"
#include "modules/link/node/cloud_level.h"

namespace scanway {
namespace {

constexpr SteadyTime kForgetAfter = 10 * kSteadySecond;
/// While more comes; at once when nothing does.
constexpr SteadyTime kCloseAtLeastEvery = 3 * kSteadySecond;
/// Finer than the map is nothing; a cube of the cloud has 4 m.
constexpr double kFinest = 0.01, kCoarsest = 4.0;

/// What goes over as it is.
constexpr const Channel* kSmall[] = {&channel::kPose, &channel::kRegistration, &channel::kMapState};
constexpr const Channel* kWhole[] = {&channel::kCostMapTile, &channel::kCostMapIndex, &channel::kPath,
                                     &channel::kParams};

bool is_detail(double voxel_m) { return voxel_m >= kFinest && voxel_m <= kCoarsest; }

OctreeFile tree_of(const octomap_t& message) {
  return {{reinterpret_cast<const char*>(message.bt_stream.data()), message.bt_stream.size()}, "OCTOMAP"};
}

/// The levels that are wanted and not there are made, by `make`; those that nobody wants go.
template <class Levels, class Make>
void keep_only(Levels& levels, const std::set<double>& wanted, const Make& make) {
  std::erase_if(levels, [&](const auto& level) { return !wanted.contains(level.first); });
  for (const double voxel_m : wanted) {
    if (!levels.contains(voxel_m)) make(voxel_m);
  }
}

}  // namespace

LinkNode::LinkNode(Bus& near, Bus& far) : near_(near), far_(far) {
  for (const Channel* channel : kSmall) pass_on(*channel);
  for (const Channel* channel : kWhole) pass_objects_on(*channel);
  near_.subscribe(channel::kCloudTile.name, [this](const BusMessage& message) {
    ++news_;
    cloud_input_.take(message.bytes,
                      [this](const cloud_tile_t& tile, const Object& object) { take_cloud_tile(tile, object); });
  });
  near_.subscribe(channel::kOctomap.name, [this](const BusMessage& message) {
    ++news_;
    octomap_input_.take(message.bytes,
                        [this](const octomap_t& octomap, const Object& object) { take_octomap(octomap, object); });
  });
  far_.subscribe(channel::kGoal.name,
                 [this](const BusMessage& message) { near_.publish(message.channel, message.bytes, message.utime); });
  far_.subscribe(channel::kMapRequest.name, [this](const BusMessage& message) {
    try {
      take_request(decode<map_request_t>(message.bytes));
    } catch (const BadMessage&) {
      ++bad_messages_;
    }
  });
}

void LinkNode::pass_on(const Channel& channel) {
  near_.subscribe(channel.name,
                  [this](const BusMessage& message) { far_.publish(message.channel, message.bytes, message.utime); });
}

/// Whole, for a sender takes the pieces of an object in their order only.
void LinkNode::pass_objects_on(const Channel& channel) {
  near_.subscribe(channel.name, [this, &channel](const BusMessage& message) {
    ++news_;
    try {
      const auto object = passing_[std::string(channel.name)].add(decode<piece_t>(message.bytes));
      if (object) publish_object(far_, channel, object->bytes, object->key, object->version, object->utime);
    } catch (const BadMessage&) {
      ++bad_messages_;
    }
  });
}

void LinkNode::take_cloud_tile(const cloud_tile_t& tile, const Object& object) {
  if (!is_detail(tile.voxel_m)) throw BadMessage("a cube of the cloud with an absurd voxel");
  cloud_[object.key] = object;
  for (auto& [voxel_m, level] : cloud_levels_) put_cloud(level, object.key, object);
}

void LinkNode::take_octomap(const octomap_t& octomap, const Object& object) {
  try {
    tree_of(octomap);
  } catch (const InputError& error) {
    throw BadMessage(error.what());
  }
  octomap_ = object;
  for (auto& [voxel_m, level] : octomap_levels_) put_octomap(level);
}

void LinkNode::take_request(const map_request_t& request) {
  Asked& asked = asked_[request.requester_name];
  asked = {{request.cloud_voxel_m, request.octomap_voxel_m}, now_};
  wake_levels();
}

/// The coarse ones first: they are whole while the finer ones are on their way.
void LinkNode::wake_levels() {
  std::set<double> cloud, octomap;
  for (const auto& [who, asked] : asked_) {
    if (is_detail(asked.details.cloud_m)) cloud.insert(asked.details.cloud_m);
    if (is_detail(asked.details.octomap_m)) octomap.insert(asked.details.octomap_m);
  }
  keep_only(cloud_levels_, cloud, [this](double voxel_m) {
    MapLevel& level = cloud_levels_.try_emplace(voxel_m, far_, channel::kCloudLevel, voxel_m).first->second;
    for (const auto& [key, object] : cloud_) put_cloud(level, key, object);
  });
  keep_only(octomap_levels_, octomap, [this](double voxel_m) {
    put_octomap(octomap_levels_.try_emplace(voxel_m, far_, channel::kOctomapLevel, voxel_m).first->second);
  });
}

void LinkNode::put_cloud(MapLevel& level, const std::string& key, const Object& object) {
  const auto tile = decode<cloud_tile_t>(object.bytes);
  if (level.holds(key, object.digest)) return;
  const auto message = encode(level.voxel_m() > tile.voxel_m ? coarsened(tile, level.voxel_m()) : tile);
  level.put(key, message, object.digest, object.version, object.utime);
}

void LinkNode::put_octomap(MapLevel& level) {
  if (octomap_.bytes.empty()) return;
  auto message = decode<octomap_t>(octomap_.bytes);
  std::set<std::string> there;
  for (const auto& [key, cube] : tree_of(message).coarsened(level.voxel_m()).cubes()) {
    there.insert(key);
    const std::uint64_t content = digest({reinterpret_cast<const std::uint8_t*>(cube.data()), cube.size()});
    if (level.holds(key, content)) continue;
    message.bt_stream.assign(cube.begin(), cube.end());
    message.nbytes = static_cast<std::int32_t>(cube.size());
    level.put(key, encode(message), content, octomap_.version, octomap_.utime);
  }
  level.retain(there);
}

void LinkNode::every_second(SteadyTime now) {
  now_ = now;
  std::erase_if(asked_, [now](const auto& asked) { return now - asked.second.heard > kForgetAfter; });
  wake_levels();
  const bool more_comes = news_ != std::exchange(news_before_, news_);
  if (more_comes && now - closed_ < kCloseAtLeastEvery) return;
  closed_ = now;
  for (auto* levels : {&cloud_levels_, &octomap_levels_}) {
    for (auto& [voxel_m, level] : *levels) level.close();
  }
}

std::map<std::string, std::int64_t> LinkNode::counters() const {
  return {{"link_requesters", static_cast<std::int64_t>(asked_.size())},
          {"link_levels", static_cast<std::int64_t>(cloud_levels_.size() + octomap_levels_.size())},
          {"link_cubes", static_cast<std::int64_t>(cloud_.size())},
          {"link_bad_messages", bad_messages_ + cloud_input_.bad_messages() + octomap_input_.bad_messages()}};
}

}  // namespace scanway
