#pragma once

#include <string>
#include <vector>

#include "modules/sick_bridge/device/lms_device.h"

namespace scanway::sick {

/// What a try of a scanner found.
struct ProbeResult {
  bool works = false;              ///< Scans came.
  std::vector<std::string> lines;  ///< What was found, for people, the conclusion last.
};

/// Tries a scanner without the bus: connects, sets it up, and watches it until ten scans came, it failed, or the time
/// is up.
ProbeResult probe_lms(const LmsAddress& address, const LmsConfig& config, int timeout_s = 45);

}  // namespace scanway::sick
