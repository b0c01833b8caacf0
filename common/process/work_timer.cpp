#include "common/process/work_timer.h"

#include <string>

#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "scanway/timing_t.hpp"

namespace scanway {

void WorkTimer::finish(std::string_view work, Utime utime) {
  timing_t message{};
  message.utime = utime;
  message.work_name = std::string(work);
  for (const auto& [stage, seconds] : stages_.finish()) {
    message.stage_name.push_back(stage);
    message.stage_seconds.push_back(seconds);
  }
  message.nstages = static_cast<std::int16_t>(message.stage_name.size());
  bus_.publish(channel::kTiming.name, encode(message), utime);
  stages_ = StageTimer();
}

}  // namespace scanway
