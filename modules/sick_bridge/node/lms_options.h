#pragma once

#include <optional>
#include <string>
#include <utility>

#include "common/robot/robot.h"
#include "modules/sick_bridge/core/start_up.h"

namespace scanway::sick {

/// How a person says what is wanted of the scanner. What is left open follows from the robot file.
struct LmsOptions {
  std::optional<double> frequency_hz;
  std::optional<double> resolution_deg;
  std::optional<std::pair<double, double>> sector_deg;  ///< As the scanner counts: 0 right, 90 ahead; -5 to 185.
  std::string echo = "first";                           ///< first, last, all
  int rssi_bits = 8;                                    ///< 0: none; 8, 16
  bool store = false;                                   ///< Keep the settings in the scanner.
};

/// Throws InputError of one line for what no LMS5xx can do.
LmsConfig lms_config(const LmsOptions& options, const Robot::Laser& laser);

}  // namespace scanway::sick
