#pragma once

#include <string_view>

#include "common/bus/bus.h"
#include "common/progress/stage_timer.h"
#include "common/time/utime.h"

namespace scanway {

/// Tells on TIMING how long the stages of each piece of a node's work took.
class WorkTimer : public StageListener {
 public:
  /// `bus` must outlive this.
  explicit WorkTimer(Bus& bus) : bus_(bus) {}

  void begin(std::string_view stage) override { stages_.begin(stage); }
  /// A piece of work ends: `work` says which, `utime` is that of the datum that was worked on.
  void finish(std::string_view work, Utime utime);

 private:
  Bus& bus_;
  StageTimer stages_;
};

}  // namespace scanway
