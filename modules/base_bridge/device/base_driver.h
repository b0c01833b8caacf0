#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/serial/serial_port.h"
#include "modules/base_bridge/core/base.h"

namespace scanway::erratic {

/// The base on a serial port: the core on the port, opened again by itself whenever it comes back. Not thread-safe:
/// commands to core() and step() belong to one thread.
class BaseDriver {
 public:
  BaseDriver(std::string port, const BaseConfig& config);
  /// Stops the robot and takes the power off its motors.
  ~BaseDriver();
  BaseDriver(const BaseDriver&) = delete;
  BaseDriver& operator=(const BaseDriver&) = delete;

  /// One turn: writes what is to be written, waits at most `timeout_ms` (10 at most) for bytes, hands them to the core.
  /// Never throws for what befalls the port.
  void step(int timeout_ms);
  Base& core() { return core_; }
  bool connected() const { return port_.has_value(); }

  /// One line for each thing that happened to the port since the last call; the same one is said once.
  std::vector<std::string> take_troubles();
  /// What is wrong with the port; empty: nothing.
  const std::string& trouble() const { return told_; }
  std::uint64_t times_opened() const { return times_opened_; }

  /// Now, as every time that the core gets: microseconds since 1970.
  static Utime now();

 private:
  void open();
  void write_all();
  void tell(const std::string& line);

  std::string path_;
  Base core_;
  std::optional<SerialPort> port_;
  Utime opened_last_ = 0;
  std::uint64_t times_opened_ = 0;
  std::string told_;
  std::vector<std::string> troubles_;
};

/// What a try of the port found.
struct ProbeResult {
  bool works = false;              ///< A base sends its odometry.
  std::vector<std::string> lines;  ///< What was found, for people.
};

/// Tries the port at both baud rates for some seconds. Moves nothing. Throws InputError when the port cannot be used.
ProbeResult probe(const std::string& port);

}  // namespace scanway::erratic
