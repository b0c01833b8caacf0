#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modules/schunk_bridge/core/pan_tilt.h"
#include "modules/schunk_bridge/device/can_socket.h"

namespace scanway::schunk {

/// The pan-tilt on a CAN interface: the core on a socket, opened again by itself whenever it comes back. Not
/// thread-safe: commands to core() and step() belong to one thread.
class PanTiltDriver {
 public:
  PanTiltDriver(std::string interface, const PanTiltConfig& config);

  /// One turn: sends what is to be sent, waits at most `timeout_ms` (10 at most) for frames, hands them to the core.
  /// What was commanded before is on its way at once. Never throws for what befalls the interface.
  void step(int timeout_ms);
  PanTilt& core() { return core_; }
  bool connected() const { return socket_.has_value(); }

  /// One line for each thing that happened to the interface since the last call; the same one is said once.
  std::vector<std::string> take_troubles();

  /// Now, as every time that the core gets: microseconds since 1970.
  static Utime now();

 private:
  void open();
  void send_all();
  void receive_all(int timeout_ms);
  void tell(const std::string& line);
  void disconnect(const std::string& why);

  std::string interface_;
  std::vector<std::uint16_t> ids_;
  PanTilt core_;
  std::optional<CanSocket> socket_;
  std::optional<CanFrame> unsent_;  // The queue of the interface was full.
  Utime opened_last_ = 0;
  bool sent_ = false;
  Utime full_since_ = 0;
  std::string told_;
  std::vector<std::string> troubles_;
};

/// Tries the interface and both modules for three seconds, and says in a few lines what is there. Moves nothing.
/// Throws InputError when the interface cannot be used.
std::vector<std::string> probe(const std::string& interface, const PanTiltConfig& config);

}  // namespace scanway::schunk
