#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>

#include "common/bus/bus.h"
#include "common/bus/channels.h"
#include "common/time/utime.h"

namespace scanway {

/// The name of a level: its voxel in millimetres, "100mm".
std::string level_name(double voxel_m);

/// Publishes one product in one detail: its tiles where they changed, then the message that closes the level.
class MapLevel {
 public:
  /// `bus` must outlive this.
  MapLevel(Bus& bus, const Channel& channel, double voxel_m) : bus_(bus), channel_(channel), voxel_m_(voxel_m) {}

  double voxel_m() const { return voxel_m_; }
  /// A tile as it is now, encoded. `content`: names what is in it, whatever its time and version.
  void put(const std::string& tile, std::span<const std::uint8_t> message, std::uint64_t content, std::int64_t version,
           Utime utime);
  bool holds(const std::string& tile, std::uint64_t content) const;
  /// The others are no more.
  void retain(const std::set<std::string>& tiles);
  /// Says what the level consists of, if that has changed.
  void close();

 private:
  struct Sent {
    std::uint64_t content = 0;
    std::int64_t digest = 0;
  };

  Bus& bus_;
  const Channel& channel_;
  double voxel_m_;
  std::map<std::string, Sent> tiles_;  // By key.
  std::int64_t version_ = 0;           // Of the newest tile.
  Utime utime_ = 0;
  bool changed_ = false;
};

}  // namespace scanway
