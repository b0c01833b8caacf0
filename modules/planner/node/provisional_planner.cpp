#include "modules/planner/node/provisional_planner.h"

#include <string>

#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "common/messages/objects.h"

namespace scanway {

ProvisionalPlanner::ProvisionalPlanner(Bus& bus, const Robot& robot, const std::vector<planning::BodyMode>& modes)
    : bus_(bus) {
  for (const planning::BodyMode mode : modes) modes_.push_back({mode, planning::Planner(robot, mode)});
}

void ProvisionalPlanner::take(const Start& start) {
  basis_.start = start;
  // A pose comes with its version of the map: until that is here, a plan would be from a place that is not mapped.
  is_new_ = is_new_ || (basis_.version && start.utime <= basis_.version->utime);
}

void ProvisionalPlanner::take(const Goal& goal) {
  basis_.goal = goal;
  is_new_ = true;
}

void ProvisionalPlanner::take(const ClosedVersion& version) {
  apply(version, map_);
  std::vector<Cell> tiles;
  for (const auto& [tile, cells] : version.changes) tiles.push_back(tile);
  for (Mode& mode : modes_) {
    if (basis_.version) {
      mode.planner.update(map_, tiles);
    } else {
      mode.planner.set_map(map_);
    }
  }
  basis_.version = version;
  basis_.version->changes.clear();
  is_new_ = true;
}

void ProvisionalPlanner::plan(bool map_up_to_date) {
  if (!is_new_ || !basis_.complete()) return;
  is_new_ = false;
  ++plans_;
  for (Mode& mode : modes_) {
    path_t message = path_message(
        basis_, mode.mode, mode.planner.plan(basis_.start->X_map_base.translation().head<2>(), basis_.goal->place));
    message.provisional = true;
    message.map_up_to_date = map_up_to_date;
    publish_object(bus_, channel::kPath, encode(message), "provisional " + message.mode, newest_.next(message),
                   message.utime);
  }
}

}  // namespace scanway
