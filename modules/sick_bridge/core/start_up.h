#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/time/utime.h"
#include "modules/sick_bridge/core/commands.h"

namespace scanway::sick {

/// What the bridge wants of the scanner.
struct LmsConfig {
  Dialect first_dialect = Dialect::cola_b;  ///< Which is tried first.
  ScanConfig scan;                          ///< Frequency, resolution and the full field of view.
  std::int32_t sector_start = -50000;       ///< The part of it that is sent, 1/10000 deg.
  std::int32_t sector_stop = 1850000;
  EchoFilter echo = EchoFilter::first;
  ScanContent content;
  bool store = false;  ///< Keep the settings when the power goes.
};

/// What the scanner said of itself; what it did not say is empty.
struct DeviceInfo {
  std::string model;
  std::string firmware;
  std::string location_name;
  std::optional<double> operating_hours;
  std::optional<unsigned> power_on_count;
  std::optional<unsigned> device_state;      ///< device_state_name().
  std::optional<unsigned> contamination;     ///< contamination_name().
  std::optional<unsigned> operating_status;  ///< operating_status_name().
  std::optional<ScanConfig> scan;
};

/// One request of the start-up, and what its answer means.
struct Step {
  std::string purpose;  ///< "log in": ends the sentence "the device does not ...".
  Request request;
  Utime patience;         ///< How long to wait for the answer.
  bool required = false;  ///< Without it there are no scans. Of all else the refusal is said, and the dialogue goes on.
  bool is_question = false;  ///< Whose refusal is counted and not said: it decides nothing.
  bool slows_down = false;   ///< From then on the device may not answer for half a minute.
  /// What is wrong with the answer, or empty; notes what the device says of itself.
  std::function<std::string(const Telegram&, DeviceInfo&)> accept;
  /// Whether to do it at all; empty: always.
  std::function<bool(const DeviceInfo&)> needed;
};

/// The start-up in SICK's order: who are you, log in, scan mode, content, sector, (store), measure, run, subscribe.
std::vector<Step> start_up_steps(const LmsConfig& config, Dialect dialect);

/// The variables that tell how the device is, one request each; asked from time to time while it measures.
std::vector<Step> status_steps(Dialect dialect);

}  // namespace scanway::sick
