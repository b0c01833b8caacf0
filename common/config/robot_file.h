#pragma once

#include <string>
#include <string_view>

#include "common/robot/robot.h"

namespace scanway {

/// The robot of a robot file (YAML, docs/robot-file.md). Keys that the file does not name keep their defaults.
/// Throws InputError for anything that the file should not hold: it names the file, the line and the key.
Robot load_robot(const std::string& path);

/// The same from text; `name` stands for the file in messages.
Robot parse_robot(std::string_view text, const std::string& name);

/// The robot file of `robot`: every key, in a fixed order. parse_robot() gives the same robot back, to the last bit.
std::string robot_text(const Robot& robot);

}  // namespace scanway
