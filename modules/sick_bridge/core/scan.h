#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "modules/sick_bridge/core/cola.h"

namespace scanway::sick {

struct EncoderReading {
  std::uint32_t position_ticks = 0;
  std::uint16_t speed = 0;  ///< Documented as ticks/mm; see docs/devices.md.
};

/// One row of values over the beams of a scan, as the device counts them.
struct ScanChannel {
  std::string content;  ///< DIST1 to DIST5: ranges of the first to the fifth echo; RSSI1 to RSSI5: their remission.
  float scale = 1.0F;   ///< Value of a count: millimetres, or digits of remission.
  float offset = 0.0F;
  std::int32_t start_angle = 0;  ///< Of the first beam, 1/10000 deg: 0 is right, 90 deg straight ahead.
  std::uint16_t step = 0;        ///< Between two beams, 1/10000 deg, rounded by the device (scan_geometry.h).
  std::vector<std::uint16_t> counts;
};

struct DevicePosition {
  std::array<float, 3> position{};
  std::array<float, 3> rotation{};
  std::uint8_t rotation_type = 0;  ///< 0 none, 1 pitch, 2 roll, 3 free.
};

/// The device's calendar clock. It has no battery and starts in 1970.
struct DeviceDate {
  std::uint16_t year = 0;
  std::uint8_t month = 0, day = 0, hour = 0, minute = 0, second = 0;
  std::uint32_t microsecond = 0;
};

/// A digital input that switched during the scan.
struct ScanEvent {
  std::string type;  ///< FDIN.
  std::uint32_t encoder_position = 0;
  std::uint32_t time_us = 0;
  std::int32_t angle = 0;  ///< 1/10000 deg.
};

/// Bits of Scan::device_status.
enum DeviceStatus : std::uint16_t { kDeviceError = 1, kPollutionWarning = 2, kPollutionError = 4 };

/// The content of an LMDscandata telegram: every block of it, as the device counts.
struct Scan {
  std::uint16_t version = 0;
  std::uint16_t device_number = 0;
  std::uint32_t serial_number = 0;
  std::uint16_t device_status = 0;         ///< Bits of DeviceStatus.
  std::uint16_t telegram_counter = 0;      ///< +1 a telegram, wraps.
  std::uint16_t scan_counter = 0;          ///< +1 a scan, wraps.
  std::uint32_t start_time_us = 0;         ///< Of the scan, on the device's clock since its start; wraps after 71 min.
  std::uint32_t transmission_time_us = 0;  ///< Of the telegram, on the same clock.
  std::uint16_t digital_inputs = 0;
  std::uint16_t digital_outputs = 0;
  std::uint16_t reserved = 0;
  std::uint32_t scan_frequency = 0;         ///< 1/100 Hz.
  std::uint32_t measurement_frequency = 0;  ///< 100 Hz.
  std::vector<EncoderReading> encoders;
  std::vector<ScanChannel> channels_16_bit;
  std::vector<ScanChannel> channels_8_bit;
  std::optional<DevicePosition> position;
  std::optional<std::string> device_name;
  std::optional<std::string> comment;
  std::optional<DeviceDate> date;
  std::vector<ScanEvent> events;  ///< Newest first.
  std::size_t unread_bytes = 0;   ///< After the last block: of a newer firmware.

  /// The channel with that content, or nullptr.
  const ScanChannel* channel(const std::string& content) const;
};

/// Whether a telegram carries a scan: sent because of a subscription, or on request.
bool is_scan(const Telegram& telegram);

/// The scan in a telegram for which is_scan() holds. Throws BadTelegram.
Scan parse_scan(const Telegram& telegram);

}  // namespace scanway::sick
