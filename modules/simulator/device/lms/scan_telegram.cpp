#include "modules/simulator/device/lms/scan_telegram.h"

#include <chrono>

namespace scanway::simulator {
namespace {

void write_channel(TelegramWriter& telegram, const ScanTelegram::Channel& channel, bool wide) {
  telegram.characters(channel.content).f32(channel.scale).f32(0.0F).i32(channel.start_angle);
  telegram.u16(channel.angular_step).u16(static_cast<unsigned>(channel.counts.size()));
  for (const std::uint16_t count : channel.counts) wide ? telegram.u16(count) : telegram.u8(count);
}

void write_head(TelegramWriter& telegram, const ScanTelegram& scan) {
  constexpr unsigned kVersion = 0, kDevice = 1, kReserved = 0;
  telegram.u16(kVersion).u16(kDevice).u32(scan.serial_number).bits(scan.status);
  telegram.u16(scan.telegram_counter).u16(scan.scan_counter).u32(scan.start_us).u32(scan.sent_us);
  telegram.bits(scan.inputs).bits(scan.outputs).u16(kReserved);
  telegram.u32(scan.scan_frequency).u32(scan.measurement_frequency);
}

void write_event(TelegramWriter& telegram, const ScanTelegram::Event& event) {
  telegram.characters("FDIN").u32(event.encoder_position).u32(event.time_us).i32(event.angle);
}

}  // namespace

ScannerDate date_of(Utime us) {
  using namespace std::chrono;
  const sys_time<microseconds> time{microseconds(us)};
  const auto midnight = floor<days>(time);
  const year_month_day day(midnight);
  const hh_mm_ss clock(time - midnight);
  return {static_cast<unsigned>(static_cast<int>(day.year())),
          static_cast<unsigned>(day.month()),
          static_cast<unsigned>(day.day()),
          static_cast<unsigned>(clock.hours().count()),
          static_cast<unsigned>(clock.minutes().count()),
          static_cast<unsigned>(clock.seconds().count()),
          static_cast<std::uint32_t>(clock.subseconds().count())};
}

void write_date(TelegramWriter& telegram, const ScannerDate& date) {
  telegram.u16(date.year).u8(date.month).u8(date.day).u8(date.hour).u8(date.minute).u8(date.second);
  telegram.u32(date.microsecond);
}

std::string encode(const ScanTelegram& scan, Cola cola, std::string_view command) {
  TelegramWriter telegram(cola, command, "LMDscandata");
  write_head(telegram, scan);
  telegram.u16(static_cast<unsigned>(scan.encoders.size()));
  for (const auto& encoder : scan.encoders) telegram.u32(encoder.position).u16(encoder.speed);
  telegram.u16(static_cast<unsigned>(scan.ranges.size()));
  for (const auto& channel : scan.ranges) write_channel(telegram, channel, true);
  telegram.u16(static_cast<unsigned>(scan.remissions.size()));
  for (const auto& channel : scan.remissions) write_channel(telegram, channel, false);
  telegram.u16(0).u16(0).u16(0);  // No position, name or comment.
  telegram.u16(scan.date ? 1 : 0);
  if (scan.date) write_date(telegram, *scan.date);
  telegram.u16(scan.event ? 1 : 0);
  if (scan.event) write_event(telegram, *scan.event);
  return telegram.frame();
}

}  // namespace scanway::simulator
