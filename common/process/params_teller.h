#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/bus/bus.h"
#include "common/robot/robot.h"
#include "common/time/utime.h"

namespace scanway {

/// Tells on PARAMS with which configuration a process runs: at its start, and again with every piece of work, so that
/// every log of the work holds it, whenever the logger was started. The process's name is the key.
class ParamsTeller {
 public:
  /// `bus` must outlive this. `start` is when the process was started, and the version of what it says first.
  ParamsTeller(Bus& bus, std::string process, const Robot& robot, Utime start);
  void tell();

 private:
  Bus& bus_;
  const std::string process_;
  const Utime start_;
  const std::vector<std::uint8_t> message_;
  std::int64_t told_ = 0;
};

}  // namespace scanway
