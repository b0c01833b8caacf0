#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/can/can_link.h"
#include "modules/schunk_bridge/core/pan_tilt.h"

namespace scanway::schunk {

/// What befell the CAN bus since the start.
struct BusCounters {
  std::uint64_t times_opened = 0;
  std::uint64_t error_frames = 0;
  std::uint64_t losses = 0;      ///< Times that received frames were dropped, since nobody fetched them in time.
  std::uint64_t times_full = 0;  ///< Times that the bus did not take a frame at once.
};

/// The pan-tilt on a CAN bus: the core on an end of it, opened again by itself whenever it comes back. Not thread-safe:
/// commands to core() and step() belong to one thread.
class PanTiltDriver {
 public:
  /// `bus`: as open_can() takes it.
  PanTiltDriver(std::string bus, const PanTiltConfig& config);

  /// One turn: sends what is to be sent, waits at most `timeout_ms` (10 at most) for frames, hands them to the core.
  /// What was commanded before is on its way at once. Never throws for what befalls the bus.
  void step(int timeout_ms);
  PanTilt& core() { return core_; }
  bool connected() const { return link_ != nullptr; }
  const BusCounters& counters() const { return counters_; }

  /// One line for each thing that happened to the bus since the last call; the same one is said once.
  std::vector<std::string> take_troubles();
  /// What keeps the bus from working, or did a moment ago; empty: nothing.
  std::string trouble() const;

  /// Now, as every time that the core gets: microseconds since 1970.
  static Utime now();

 private:
  void open();
  void send_all();
  void receive_all(int timeout_ms);
  void tell(const std::string& line);
  void disconnect(const std::string& why);

  std::string bus_;
  std::vector<std::uint16_t> ids_;
  PanTilt core_;
  std::unique_ptr<CanLink> link_;
  BusCounters counters_;
  std::optional<CanFrame> unsent_;  // The queue of the interface was full.
  Utime opened_last_ = 0;
  bool sent_ = false;
  Utime full_since_ = 0;
  std::string told_;
  Utime told_at_ = 0;
  std::vector<std::string> troubles_;
};

/// What a try of the bus and its modules found.
struct ProbeResult {
  bool works = false;              ///< Both axes tell where they are.
  std::vector<std::string> lines;  ///< What was found, for people.
};

/// Tries the bus and both modules for that time. Moves nothing. Throws InputError when the bus cannot be used.
ProbeResult probe(const std::string& bus, const PanTiltConfig& config, Utime time = 3 * kMicrosecondsPerSecond);

}  // namespace scanway::schunk
