#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/time/utime.h"
#include "modules/simulator/device/lms/telegram.h"

namespace scanway::simulator {

/// The scanner's calendar, which begins with 1970 when it is switched on.
struct ScannerDate {
  unsigned year = 1970, month = 1, day = 1, hour = 0, minute = 0, second = 0;
  std::uint32_t microsecond = 0;
};

/// The date `us` microseconds after 1970 began.
ScannerDate date_of(Utime us);

/// One scan as the scanner counts it. Not there: position, device name and comment, which no recording holds.
struct ScanTelegram {
  struct Encoder {
    std::uint32_t position = 0;
    std::uint16_t speed = 0;
  };
  struct Channel {
    std::string content;             ///< DIST1 to DIST5, RSSI1 to RSSI5.
    float scale = 1.0F;              ///< Millimetres, or digits, of a count.
    std::int32_t start_angle = 0;    ///< 1/10000 deg: 0 right, 90 deg ahead.
    std::uint16_t angular_step = 0;  ///< 1/10000 deg.
    std::vector<std::uint16_t> counts;
  };
  struct Event {
    std::uint32_t encoder_position = 0, time_us = 0;
    std::int32_t angle = 0;
  };

  std::uint32_t serial_number = 18'110'550;
  unsigned status = 0;
  std::uint16_t telegram_counter = 0, scan_counter = 0;
  std::uint32_t start_us = 0, sent_us = 0;  ///< Since it was switched on; they wrap.
  unsigned inputs = 0, outputs = 0;
  std::uint32_t scan_frequency = 2500;        ///< 1/100 Hz.
  std::uint32_t measurement_frequency = 540;  ///< 100 Hz.
  std::vector<Encoder> encoders;
  std::vector<Channel> ranges, remissions;
  std::optional<ScannerDate> date;
  std::optional<Event> event;
};

/// `command`: "sSN" of a subscription, "sRA" on request.
std::string encode(const ScanTelegram& scan, Cola cola, std::string_view command = "sSN");

/// Year to microsecond, as every telegram has it.
void write_date(TelegramWriter& telegram, const ScannerDate& date);

}  // namespace scanway::simulator
