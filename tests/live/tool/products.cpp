#include "tests/live/tool/products.h"

#include <algorithm>
#include <optional>

#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "common/messages/cost_map_message.h"
#include "common/messages/digest.h"
#include "scanway/path_t.hpp"

namespace scanway::test {
namespace {

const Channel kProducts[] = {channel::kCostMapTile, channel::kCostMapIndex, channel::kCloudTile, channel::kOctomap,
                             channel::kPath};
constexpr int kModes = 2;

bool is_history(const std::string& channel) {  // Of which every version counts.
  return channel == channel::kCostMapIndex.name || channel == channel::kPath.name || channel == channel::kOctomap.name;
}

}  // namespace

void Products::listen(Bus& bus) {
  for (const Channel& product : kProducts) {
    bus.subscribe(product.name, [this](const BusMessage& message) { take(message); });
  }
}

void Products::take(const BusMessage& message) {
  const std::string channel(message.channel);
  const bool wanted = std::any_of(std::begin(kProducts), std::end(kProducts),
                                  [&](const Channel& product) { return product.name == channel; });
  if (!wanted) return;
  const auto piece = decode<piece_t>(message.bytes);
  if (channel == channel::kCostMapTile.name && !piece.key.starts_with("hostile")) {
    newest_tile_ = std::max(newest_tile_, piece.version);
  }
  const std::optional<Object> object = assemblers_[channel].add(piece);
  if (!object || object->key.starts_with("provisional")) return;
  try {
    note(channel, *object);
  } catch (const BadMessage&) {
    ++lies_;
  }
}

void Products::note(const std::string& channel, const Object& object) {
  if (channel == channel::kCostMapIndex.name) indices_[object.version] = decode<cost_map_index_t>(object.bytes);
  if (channel == channel::kPath.name) ++paths_[decode<path_t>(object.bytes).map_version];
  digests_[{channel, object.key}][object.version] = object.digest;
}

bool Products::has(const std::string& channel, const std::string& key, std::int64_t version) const {
  const auto found = digests_.find({channel, key});
  return found != digests_.end() && found->second.contains(version);
}

bool Products::complete(std::int64_t version) const {
  const auto paths = paths_.find(version);
  return cost_map_complete(version) && has("OCTOMAP", "map", version) && paths != paths_.end() &&
         paths->second >= kModes;
}

bool Products::cost_map_complete(std::int64_t version) const {
  const auto index = indices_.find(version);
  if (index == indices_.end()) return false;
  return std::all_of(index->second.tiles.begin(), index->second.tiles.end(), [this](const cost_tile_entry_t& tile) {
    return has("COST_MAP_TILE", tile_key({tile.tile_x, tile.tile_y}), tile.map_version);
  });
}

std::string Products::text() const {
  std::string text;
  for (const auto& [name, versions] : digests_) {
    for (auto version = is_history(name.first) ? versions.begin() : std::prev(versions.end());
         version != versions.end(); ++version) {
      text += name.first + " " + name.second + " " + std::to_string(version->first) + " " + hex(version->second) + "\n";
    }
  }
  return text;
}

}  // namespace scanway::test
