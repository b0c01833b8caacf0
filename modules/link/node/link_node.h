#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus.h"
#include "common/bus/channels.h"
#include "common/clock/steady_time.h"
#include "common/messages/object_input.h"
#include "modules/link/node/map_level.h"
#include "scanway/cloud_tile_t.hpp"
#include "scanway/map_request_t.hpp"
#include "scanway/octomap_t.hpp"

namespace scanway {

/// Between the robot's bus and one behind a slow link. What is small, the cost map and the paths go over; cloud and
/// OctoMap only as levels of detail that somebody over there asks for; goals come back.
class LinkNode {
 public:
  /// `near` and `far` must outlive this.
  LinkNode(Bus& near, Bus& far);

  /// Once a second: forgets who has not asked for long, and closes the levels that are complete again.
  void every_second(SteadyTime now);
  std::size_t news() const { return news_; }  ///< Messages taken so far.
  std::map<std::string, std::int64_t> counters() const;

 private:
  struct Details {
    double cloud_m = 0.0, octomap_m = 0.0;
  };
  struct Asked {
    Details details;
    SteadyTime heard = 0;
  };
  using Levels = std::map<double, MapLevel>;  // By their voxel.

  void pass_on(const Channel& channel);
  void pass_objects_on(const Channel& channel);
  void take_cloud_tile(const cloud_tile_t& tile, const Object& object);
  void take_octomap(const octomap_t& octomap, const Object& object);
  void take_request(const map_request_t& request);
  void wake_levels();
  void put_cloud(MapLevel& level, const std::string& key, const Object& object);
  void put_octomap(MapLevel& level);

  Bus& near_;
  Bus& far_;
  std::map<std::string, ObjectAssembler> passing_;  // By channel.
  ObjectInput<cloud_tile_t> cloud_input_;
  ObjectInput<octomap_t> octomap_input_;
  std::map<std::string, Object> cloud_;  // Its tiles in full detail, as they came, by key.
  Object octomap_;                       // The newest; without bytes: none came yet.
  std::map<std::string, Asked> asked_;   // By who did.
  Levels cloud_levels_, octomap_levels_;
  SteadyTime now_ = 0, closed_ = 0;
  std::size_t news_ = 0, news_before_ = 0;
  std::int64_t bad_messages_ = 0;
};

}  // namespace scanway
