#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "common/bus/bus.h"
#include "modules/base_bridge/core/base.h"
#include "scanway/base_command_t.hpp"

namespace scanway::erratic {

/// The base on the bus: BASE_COMMAND in, ODOMETRY out. A turn of the bridge is obey(), the device's turn, tell().
class BaseNode {
 public:
  /// Both must outlive this.
  BaseNode(Bus& bus, Base& base);

  /// Drives as the newest command says, if one came since the last time.
  void obey(Utime now);
  /// Publishes where the base is and says what happened since the last time.
  void tell();

  std::map<std::string, std::int64_t> counters() const;
  /// What is wrong, in one line; empty: nothing.
  std::string summary(Utime now) const;

 private:
  void take(const BusMessage& message);
  void publish_pose(const WheelPose& pose);

  Bus& bus_;
  Base& base_;
  std::optional<base_command_t> waiting_;
  Utime told_ = 0;  // Time of the pose that was published last.
  std::string last_refusal_;
  Utime refused_at_ = 0;
  std::int64_t commands_ = 0, refused_ = 0, bad_messages_ = 0, poses_ = 0, stalls_ = 0, ran_out_ = 0;
};

}  // namespace scanway::erratic
