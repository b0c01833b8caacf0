#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/bus/bus.h"
#include "modules/sick_bridge/device/lms_device.h"
#include "modules/sick_bridge/node/line_archive.h"

namespace scanway::sick {

struct SickOptions {
  bool laser_scan = true;  ///< LASER_SCAN, for LCM's tools.
  bool raw = false;        ///< LASER_RAW: every telegram as it came.
  ArchiveLimits archive;
};

/// The scanner on the bus: LASER_LINE, and LASER_SCAN and LASER_RAW if wanted, out; LINE_REQUEST in.
class SickNode {
 public:
  /// `bus` and `device` must outlive this. `numbered_since`: when this process began to number its lines.
  SickNode(Bus& bus, LmsDevice& device, Utime numbered_since, const SickOptions& options = {});

  /// Waits at most `timeout_ms` for the scanner and publishes what came; sends again what was asked for. Returns what
  /// is wrong and was not said yet, a line each.
  std::vector<std::string> run(int timeout_ms);
  /// What the scanner is, once a connection when its first scan came; else empty.
  std::string take_welcome();

  /// What people should know now, in one line; empty: all is well.
  std::string summary() const;
  /// What was lost, bad or asked for so far, by name.
  std::map<std::string, std::int64_t> counters() const;

 private:
  void take_request(const BusMessage& message);
  void publish(const TimedScan& timed);
  void publish_line(const TimedScan& timed);
  void publish_raw(const std::vector<std::uint8_t>& frame);

  Bus& bus_;
  LmsDevice& device_;
  const Utime numbered_since_;
  const SickOptions options_;
  LineArchive archive_;
  std::int64_t lines_ = 0;
  std::int64_t pieces_ = 0;
  std::int64_t unusable_scans_ = 0;
  std::int64_t requests_ = 0;
  std::int64_t bad_requests_ = 0;
  std::int64_t other_numberings_ = 0;
  std::uint16_t device_status_ = 0;  // Of the newest scan.
  std::int64_t connection_ = 0;
  bool works_ = false;  // A scan came over this connection.
  std::string welcome_;
  std::string complaint_;  // The last one of this connection.
};

}  // namespace scanway::sick
