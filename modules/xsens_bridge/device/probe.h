#pragma once

#include <string>
#include <vector>

#include "modules/xsens_bridge/device/tracker_device.h"

namespace scanway::xsens {

/// What a try of a tracker found.
struct ProbeResult {
  bool works = false;              ///< Orientations came.
  std::vector<std::string> lines;  ///< What was found, for people, the conclusion last.
};

/// Tries a tracker without the bus: finds its rate, sets it up, and watches it until a second's orientations came or
/// the time is up.
ProbeResult probe_tracker(const TrackerAddress& address, const TrackerConfig& config, int timeout_s = 30);

}  // namespace scanway::xsens
