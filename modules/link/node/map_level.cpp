#include "modules/link/node/map_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/messages/codec.h"
#include "common/messages/objects.h"
#include "scanway/map_level_t.hpp"

namespace scanway {

std::string level_name(double voxel_m) { return fmt::format("{}mm", std::lround(1000.0 * voxel_m)); }

bool MapLevel::holds(const std::string& tile, std::uint64_t content) const {
  const auto known = tiles_.find(level_name(voxel_m_) + " " + tile);
  return known != tiles_.end() && known->second.content == content;
}

void MapLevel::put(const std::string& tile, std::span<const std::uint8_t> message, std::uint64_t content,
                   std::int64_t version, Utime utime) {
  const std::string key = level_name(voxel_m_) + " " + tile;
  const std::uint64_t name = publish_object(bus_, channel_, message, key, version, utime);
  tiles_[key] = {content, static_cast<std::int64_t>(name)};
  version_ = std::max(version_, version);
  utime_ = std::max(utime_, utime);
  changed_ = true;
}

void MapLevel::retain(const std::set<std::string>& tiles) {
  const std::size_t prefix = level_name(voxel_m_).size() + 1;
  const auto gone = std::erase_if(tiles_, [&](const auto& tile) { return !tiles.contains(tile.first.substr(prefix)); });
  changed_ = changed_ || gone > 0;
}

void MapLevel::close() {
  if (!std::exchange(changed_, false)) return;
  map_level_t level{};
  level.utime = utime_;
  level.map_version = version_;
  level.level_channel = channel_.name;
  level.voxel_m = voxel_m_;
  for (const auto& [key, sent] : tiles_) {
    level.tile_key.push_back(key);
    level.tile_digest.push_back(sent.digest);
  }
  level.ntiles = static_cast<std::int32_t>(tiles_.size());
  publish_object(bus_, channel::kMapLevel, encode(level), std::string(channel_.name) + " " + level_name(voxel_m_),
                 version_, utime_);
}

}  // namespace scanway
