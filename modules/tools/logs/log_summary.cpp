#include "modules/tools/logs/log_summary.h"

#include <algorithm>

#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "common/messages/layout.h"
#include "scanway/params_t.hpp"
#include "scanway/piece_t.hpp"

namespace scanway::tools {

namespace {

using Bytes = std::span<const std::uint8_t>;

/// Why a message of a known type is none; empty if it is one, or of a type that nobody here knows.
std::string fault_of(Bytes message) {
  const Layout* const layout = find_layout(fingerprint(message));
  return layout == nullptr ? std::string() : find_fault(*layout, message);
}

void note_fault(ChannelSummary& channel, const std::string& fault) {
  if (channel.first_fault.empty()) channel.first_fault = fault;
}

void expect_type(ChannelSummary& channel, const Channel* known, Bytes message) {
  if (known != nullptr && !known->carries(type_name(fingerprint(message)))) ++channel.unexpected;
}

void add_object(LogSummary& log, ChannelSummary& channel, const Channel* known, const Object& object) {
  ++channel.object_fingerprints[fingerprint(object.bytes)];
  expect_type(channel, known, object.bytes);
  if (const std::string fault = fault_of(object.bytes); !fault.empty()) {
    ++channel.bad_objects;
    note_fault(channel, "object '" + object.key + "': " + fault);
  } else if (fingerprint(object.bytes) == params_t::getHash()) {
    log.schema = decode<params_t>(object.bytes).schema_version;
  }
}

void add_piece(LogSummary& log, ChannelSummary& channel, const Channel* known, Bytes message) {
  const piece_t piece = decode<piece_t>(message);
  if (!channel.assembler) channel.assembler.emplace();
  const AssemblerCounters before = channel.assembler->counters();
  const auto object = channel.assembler->add(piece);
  const AssemblerCounters& after = channel.assembler->counters();
  if (object) add_object(log, channel, known, *object);
  if (after.bad_objects > before.bad_objects) {
    ++channel.bad_objects;
    note_fault(channel, "object '" + piece.key + "' version " + std::to_string(piece.version) +
                            " is not what its digest " + hex(static_cast<std::uint64_t>(piece.digest)) + " says");
  }
  if (after.bad_pieces > before.bad_pieces) {
    ++channel.bad_messages;
    note_fault(channel, "a piece of '" + piece.key + "' contradicts itself");
  }
}

void add_message(LogSummary& log, ChannelSummary& channel, const Channel* known, Bytes message) {
  ++channel.fingerprints[fingerprint(message)];
  if (const std::string fault = fault_of(message); !fault.empty()) {
    ++channel.bad_messages;
    note_fault(channel, fault);
  } else if (fingerprint(message) == piece_t::getHash()) {
    add_piece(log, channel, known, message);
  } else {
    expect_type(channel, known, message);
  }
}

void add_event(LogSummary& log, const LogEvent& event) {
  ChannelSummary& channel = log.channels[std::string(event.channel)];
  if (channel.count == 0) channel.first_utime = channel.last_utime = event.utime;
  if (log.events == 0) log.first_utime = log.last_utime = event.utime;
  for (auto* times : {&channel.first_utime, &log.first_utime}) *times = std::min(*times, event.utime);
  for (auto* times : {&channel.last_utime, &log.last_utime}) *times = std::max(*times, event.utime);
  ++log.events;
  ++channel.count;
  channel.bytes += event.bytes.size();
  add_message(log, channel, find_channel(event.channel), event.bytes);
}

}  // namespace

std::uint64_t ChannelSummary::missing_pieces() const {
  std::uint64_t missing = 0;
  if (assembler) {
    for (const IncompleteObject& object : assembler->incomplete()) {
      missing += static_cast<std::uint64_t>(object.missing_count);
    }
  }
  return missing;
}

double ChannelSummary::rate_hz() const {
  const double span_s = (static_cast<double>(last_utime) - static_cast<double>(first_utime)) / kMicrosecondsPerSecond;
  return span_s > 0 ? static_cast<double>(count - 1) / span_s : 0.0;
}

bool LogSummary::damaged() const {
  return damaged_stretches > 0 ||
         std::any_of(channels.begin(), channels.end(), [](const auto& entry) { return entry.second.damaged(); });
}

LogSummary summarize(LogReader& log) {
  LogSummary summary;
  while (const auto event = log.next()) add_event(summary, *event);
  summary.file_bytes = log.file_bytes();
  summary.trouble = log.trouble();
  summary.cut = log.cut();
  summary.damaged_stretches = log.damage_count();
  summary.skipped_bytes = log.skipped_bytes();
  return summary;
}

std::string type_name(std::int64_t fingerprint) {
  const Layout* const layout = find_layout(fingerprint);
  return layout != nullptr ? layout->name : hex(static_cast<std::uint64_t>(fingerprint));
}

}  // namespace scanway::tools
