#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/robot/robot.h"
#include "modules/replay/verify/recorded_log.h"

namespace scanway {

/// With what mapper and planner ran, as the log's PARAMS say.
struct LogConfiguration {
  std::optional<Robot> mapper;
  std::optional<Robot> planner;
  std::vector<std::string> missing;  ///< PARAMS that are not whole, or not there at all.
  std::vector<std::string> notes;    ///< What people should know of them.
};

/// Each process says its own (its name is the key); what neither says is taken from the log's robot. Throws InputError
/// for a configuration that is whole and cannot be used.
LogConfiguration configuration_of(const RecordedLog& log, const std::string& path);

}  // namespace scanway
