#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "modules/sick_bridge/core/cola.h"
#include "modules/sick_bridge/core/scan.h"

/// Requests to the device, each as a frame that is ready to be sent.
namespace scanway::sick {

/// A request, and what its answer is called.
struct Request {
  std::string answer;  ///< Command of the answer: sRA, sWA, sAN or sEA.
  std::string name;
  std::string frame;
};

/// What the scanner is set to. Angles of the LMS5xx are fixed; a sector is cut with the output range.
struct ScanConfig {
  std::uint32_t frequency = 2500;     ///< 1/100 Hz.
  std::uint32_t resolution = 1667;    ///< 1/10000 deg.
  std::int32_t start_angle = -50000;  ///< 1/10000 deg.
  std::int32_t stop_angle = 1850000;

  bool operator==(const ScanConfig&) const = default;
};

enum class EchoFilter : std::uint8_t { first = 0, all = 1, last = 2 };

/// Which blocks a scan's telegram has.
struct ScanContent {
  std::uint16_t channels = 1;  ///< The device ignores it: the echo filter decides. Drivers send 1, or 0x1F for all.
  bool rssi = true;
  bool rssi_16_bit = false;  ///< Not on an LMS5xx since V1.10.
  std::uint16_t encoders = 0;
  bool position = false;
  bool device_name = false;
  bool comment = false;
  bool date = true;
  std::uint16_t every = 1;  ///< Send every n-th scan.
};

Request read_variable(Dialect dialect, std::string_view name);
/// A method without arguments: LMCstartmeas, LMCstopmeas, Run, mEEwriteall.
Request call_method(Dialect dialect, std::string_view name);
Request subscribe(Dialect dialect, std::string_view event, bool on);

/// Logs in as authorised client with the factory's password.
Request log_in(Dialect dialect);
/// Answers 0 for success, unlike the login and Run. Acts after Run.
Request set_scan_config(Dialect dialect, const ScanConfig& config);
Request set_echo_filter(Dialect dialect, EchoFilter filter);
Request set_scan_content(Dialect dialect, const ScanContent& content);
Request set_output_range(Dialect dialect, const ScanConfig& range);
/// Which dialect the host port speaks after the next start, once stored.
Request set_host_dialect(Dialect dialect, Dialect wanted);
/// Source of the encoder's ticks: a fixed speed, or the encoder.
Request set_encoder_source(Dialect dialect, bool encoder);
/// 0 off, 1 single increments, 2 direction by phase, 3 direction by level.
Request set_encoder_setting(Dialect dialect, std::uint8_t setting);
Request set_encoder_resolution(Dialect dialect, float mm_per_tick);
Request set_date(Dialect dialect, const DeviceDate& date);

}  // namespace scanway::sick
