#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "common/bus/bus.h"
#include "common/messages/object_assembler.h"
#include "scanway/cost_map_index_t.hpp"

namespace scanway::test {

/// The objects that mapper and planner have published, by channel and key, and the digest of each version. What is
/// provisional is left out.
class Products {
 public:
  /// Subscribes to all of them.
  void listen(Bus& bus);
  void take(const BusMessage& piece);

  /// Whether the index of a version of the cost map, or a tile of it, has begun to come.
  bool begun(std::int64_t version) const { return newest_tile_ >= version; }
  /// Whether a version of the cost map is here with all its tiles.
  bool cost_map_complete(std::int64_t version) const;
  /// The same, with its OctoMap and its paths.
  bool complete(std::int64_t version) const;
  /// A line an object: channel, key, version, digest; of tiles the newest version only.
  std::string text() const;
  std::size_t lies() const { return lies_; }  ///< Objects that were not what their channel says.

 private:
  using Name = std::pair<std::string, std::string>;

  void note(const std::string& channel, const Object& object);
  bool has(const std::string& channel, const std::string& key, std::int64_t version) const;

  std::map<std::string, ObjectAssembler> assemblers_;
  std::map<Name, std::map<std::int64_t, std::uint64_t>> digests_;
  std::map<std::int64_t, cost_map_index_t> indices_;
  std::map<std::int64_t, int> paths_;  // By the version of the map.
  std::size_t lies_ = 0;
  std::int64_t newest_tile_ = 0;
};

}  // namespace scanway::test
