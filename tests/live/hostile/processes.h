#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/bus/lcm_bus.h"
#include "common/delivery/live_bus.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/planner/node/planner_node.h"

namespace scanway::test {

/// A mapper and a planner on one bus, as their processes are, but all in the caller's thread.
class Processes {
 public:
  Processes();

  /// Puts bytes on the bus, and lets both processes take them. Returns what that allocated.
  std::size_t tell(std::string_view channel, const std::vector<std::uint8_t>& bytes);
  /// Lets both go on until nothing moves any more, over a silence that lets them close what waits.
  void settle();

  MapperNode& mapper() { return mapper_; }
  PlannerNode& planner() { return planner_; }
  /// The process's last counters on HEALTH, those of its node included.
  const std::map<std::string, std::int64_t>& health(const std::string& process) { return health_[process]; }

 private:
  void turn();
  bool dispatch();

  LcmBus lcm_;
  LiveBus mapper_bus_, planner_bus_;
  MapperNode mapper_;
  PlannerNode planner_;
  std::map<std::string, std::map<std::string, std::int64_t>> health_;
  bool told_ = false;
};

}  // namespace scanway::test
