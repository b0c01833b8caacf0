#pragma once

#include <cstdint>
#include <string>

#include "common/time/utime.h"
#include "scanway/params_t.hpp"

namespace scanway {

/// The version of the configuration's schema that this program writes.
constexpr std::int32_t kParamsSchema = 1;
/// PARAMS' key on its channel.
constexpr const char* kParamsKey = "robot";

params_t params_message(Utime utime, std::string robot_yaml);
/// The robot file's text. Throws BadMessage for a schema that is newer than this program.
std::string robot_yaml_of(const params_t& message);

}  // namespace scanway
