#include "modules/sick_bridge/core/scan.h"

#include <utility>

#include "modules/sick_bridge/core/parameters.h"

namespace scanway::sick {
namespace {

constexpr std::uint16_t kMaxEncoders = 8;   // An LMS5xx has up to 3.
constexpr std::uint16_t kMaxChannels = 16;  // It has up to 5 of each width.
constexpr std::uint16_t kMaxEvents = 64;

std::uint16_t read_count(ParameterReader& reader, std::uint16_t limit, const char* what) {
  const std::uint16_t count = reader.u16();
  if (count > limit) throw BadTelegram("says " + std::to_string(count) + ' ' + what);
  return count;
}

/// Flags say 0 or 1, and nothing else, whether their block follows.
bool read_flag(ParameterReader& reader, const char* what) { return read_count(reader, 1, what) == 1; }

void read_head(ParameterReader& reader, Scan& scan) {
  scan.version = reader.u16();
  scan.device_number = reader.u16();
  scan.serial_number = reader.u32();
  scan.device_status = reader.bits();
  scan.telegram_counter = reader.u16();
  scan.scan_counter = reader.u16();
  scan.start_time_us = reader.u32();
  scan.transmission_time_us = reader.u32();
  scan.digital_inputs = reader.bits();
  scan.digital_outputs = reader.bits();
  scan.reserved = reader.u16();
  scan.scan_frequency = reader.u32();
  scan.measurement_frequency = reader.u32();
}

std::vector<EncoderReading> read_encoders(ParameterReader& reader) {
  std::vector<EncoderReading> encoders(read_count(reader, kMaxEncoders, "encoders"));
  for (EncoderReading& encoder : encoders) {
    encoder.position_ticks = reader.u32();
    encoder.speed = reader.u16();
  }
  return encoders;
}

ScanChannel read_channel(ParameterReader& reader, int value_size) {
  ScanChannel channel;
  channel.content = reader.word(5);
  channel.scale = reader.f32();
  channel.offset = reader.f32();
  channel.start_angle = reader.i32();
  channel.step = reader.u16();
  const std::size_t count = reader.u16();
  if (!reader.can_hold(count, static_cast<std::size_t>(value_size))) throw BadTelegram("a channel ends too early");
  channel.counts.resize(count);
  for (std::uint16_t& value : channel.counts) value = value_size == 2 ? reader.u16() : reader.u8();
  return channel;
}

std::vector<ScanChannel> read_channels(ParameterReader& reader, int value_size) {
  std::vector<ScanChannel> channels(read_count(reader, kMaxChannels, "channels"));
  for (ScanChannel& channel : channels) channel = read_channel(reader, value_size);
  return channels;
}

DevicePosition read_position(ParameterReader& reader) {
  DevicePosition position;
  for (float& value : position.position) value = reader.f32();
  for (float& value : position.rotation) value = reader.f32();
  position.rotation_type = reader.u8();
  return position;
}

DeviceDate read_date(ParameterReader& reader) {
  DeviceDate date;
  date.year = reader.u16();
  date.month = reader.u8();
  date.day = reader.u8();
  date.hour = reader.u8();
  date.minute = reader.u8();
  date.second = reader.u8();
  date.microsecond = reader.u32();
  return date;
}

ScanEvent read_event(ParameterReader& reader) {
  ScanEvent event;
  event.type = reader.word(4);
  event.encoder_position = reader.u32();
  event.time_us = reader.u32();
  event.angle = reader.i32();
  return event;
}

/// How many bytes the lengths of the device's name and of the comment take in CoLa-B. No recording has either.
struct LengthSizes {
  int name;
  int comment;
};

/// All blocks after the channels. What stays unread is the caller's to judge.
void read_tail(ParameterReader& reader, LengthSizes sizes, Scan& scan) {
  if (read_flag(reader, "positions")) scan.position = read_position(reader);
  if (read_flag(reader, "names")) scan.device_name = reader.text(sizes.name);
  if (read_flag(reader, "comments")) scan.comment = reader.text(sizes.comment);
  if (read_flag(reader, "dates")) scan.date = read_date(reader);
  scan.events.resize(read_count(reader, kMaxEvents, "events"));
  for (ScanEvent& event : scan.events) event = read_event(reader);
}

/// Whether the tail fits to its last byte with these sizes of the lengths; if so, it is put into `scan`.
bool read_tail_exactly(ParameterReader reader, LengthSizes sizes, Scan& scan) {
  Scan attempt;
  try {
    read_tail(reader, sizes, attempt);
  } catch (const BadTelegram&) {
    return false;
  }
  if (!reader.at_end()) return false;
  scan.position = attempt.position;
  scan.device_name = std::move(attempt.device_name);
  scan.comment = std::move(attempt.comment);
  scan.date = attempt.date;
  scan.events = std::move(attempt.events);
  return true;
}

}  // namespace

const ScanChannel* Scan::channel(const std::string& content) const {
  for (const auto* channels : {&channels_16_bit, &channels_8_bit}) {
    for (const ScanChannel& candidate : *channels) {
      if (candidate.content == content) return &candidate;
    }
  }
  return nullptr;
}

bool is_scan(const Telegram& telegram) {
  return telegram.name == "LMDscandata" && (telegram.command == "sSN" || telegram.command == "sRA");
}

Scan parse_scan(const Telegram& telegram) {
  ParameterReader reader(telegram);
  Scan scan;
  read_head(reader, scan);
  scan.encoders = read_encoders(reader);
  scan.channels_16_bit = read_channels(reader, 2);
  scan.channels_8_bit = read_channels(reader, 1);
  // The listing's sizes first; then those that drivers use for the same fields of other telegrams.
  for (const LengthSizes sizes : {LengthSizes{2, 1}, LengthSizes{2, 2}, LengthSizes{1, 1}, LengthSizes{1, 2}}) {
    if (read_tail_exactly(reader, sizes, scan)) return scan;
  }
  read_tail(reader, LengthSizes{2, 1}, scan);
  // A checksum vouches for what a newer firmware may have appended; in CoLa-A it can only be damage.
  if (telegram.dialect == Dialect::cola_a) throw BadTelegram("more follows after its last block");
  scan.unread_bytes = reader.rest().size();
  return scan;
}

}  // namespace scanway::sick
