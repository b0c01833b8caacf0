#include "modules/tools/logs/info.h"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/files/printable.h"
#include "modules/tools/logs/log_summary.h"

namespace scanway::tools {

namespace {

using Json = nlohmann::ordered_json;

/// "a", or "a, b" where a channel carries several types.
std::string type_names(const std::map<std::int64_t, std::uint64_t>& fingerprints) {
  std::string names;
  for (const auto& [fingerprint, count] : fingerprints) names += (names.empty() ? "" : ", ") + type_name(fingerprint);
  return names;
}

std::string types_of(const ChannelSummary& channel) {
  if (!channel.assembler) return type_names(channel.fingerprints);
  return channel.object_fingerprints.empty() ? "(pieces)" : type_names(channel.object_fingerprints) + " (pieces)";
}

Json objects_json(const ChannelSummary& channel) {
  const AssemblerCounters& counters = channel.assembler->counters();
  return {{"type", type_names(channel.object_fingerprints)},
          {"complete", counters.objects},
          {"incomplete", channel.assembler->incomplete().size()},
          {"superseded", counters.superseded_objects},
          {"crowded_out", counters.crowded_out},
          {"bad", channel.bad_objects},
          {"missing_pieces", channel.missing_pieces()},
          {"repeated_pieces", counters.repeated_pieces}};
}

Json channel_json(const std::string& name, const ChannelSummary& channel) {
  Json json = {{"channel", printable(name)},
               {"type", type_names(channel.fingerprints)},
               {"count", channel.count},
               {"rate_hz", channel.rate_hz()},
               {"bytes", channel.bytes},
               {"first_utime", channel.first_utime},
               {"last_utime", channel.last_utime},
               {"bad_messages", channel.bad_messages},
               {"unexpected_type", channel.unexpected},
               {"fault", printable(channel.first_fault)}};
  if (channel.assembler) json["objects"] = objects_json(channel);
  return json;
}

Json to_json(const std::string& path, const LogSummary& log) {
  Json channels = Json::array();
  for (const auto& [name, channel] : log.channels) channels.push_back(channel_json(name, channel));
  return {{"log", printable(path)},
          {"bytes", log.file_bytes},
          {"events", log.events},
          {"first_utime", log.first_utime},
          {"last_utime", log.last_utime},
          {"schema", log.schema ? Json(*log.schema) : Json(nullptr)},
          {"cut", log.cut},
          {"damaged", log.damaged()},
          {"damaged_stretches", log.damaged_stretches},
          {"skipped_bytes", log.skipped_bytes},
          {"trouble", log.trouble},
          {"channels", channels}};
}

std::string remarks_of(const ChannelSummary& channel) {
  std::string remarks;
  const auto add = [&](std::uint64_t count, const std::string& what) {
    if (count > 0) remarks += fmt::format("{}{} {}", remarks.empty() ? "" : ", ", count, what);
  };
  if (channel.assembler) {
    const AssemblerCounters& counters = channel.assembler->counters();
    const std::size_t incomplete = channel.assembler->incomplete().size();
    remarks = fmt::format("{} {} complete", counters.objects, counters.objects == 1 ? "object" : "objects");
    add(incomplete, fmt::format("incomplete ({} pieces missing)", channel.missing_pieces()));
    add(counters.superseded_objects, "superseded");
    add(counters.crowded_out, "given up for lack of memory");
    add(counters.repeated_pieces, "pieces repeated");
  }
  add(channel.bad_objects, "bad objects");
  add(channel.bad_messages, "bad messages");
  add(channel.unexpected, "not of the channel's type");
  return remarks;
}

void print_table(const std::string& path, const LogSummary& log) {
  std::cout << fmt::format("{}: {} bytes, {} events in {:.1f} s", printable(path), log.file_bytes, log.events,
                           (static_cast<double>(log.last_utime) - static_cast<double>(log.first_utime)) * 1e-6);
  std::cout << (log.schema ? fmt::format(", configuration of schema {}\n\n", *log.schema)
                           : std::string(", no configuration\n\n"));
  std::size_t name_width = 7;
  std::size_t type_width = 4;
  for (const auto& [name, channel] : log.channels) {
    name_width = std::max(name_width, printable(name).size());
    type_width = std::max(type_width, types_of(channel).size());
  }
  const auto row = [&](const auto&... cells) {
    std::string line = fmt::format("{:<{}}  {:<{}}  {:>8}  {:>9}  {:>12}  {:>10}  {:>10}  {}", cells...);
    line.erase(line.find_last_not_of(' ') + 1);
    std::cout << line << '\n';
  };
  row("channel", name_width, "type", type_width, "messages", "rate (Hz)", "bytes", "from (s)", "to (s)", "");
  const auto since_start = [&](Utime utime) {
    return fmt::format("{:.3f}", (static_cast<double>(utime) - static_cast<double>(log.first_utime)) * 1e-6);
  };
  for (const auto& [name, channel] : log.channels) {
    row(printable(name), name_width, types_of(channel), type_width, channel.count,
        fmt::format("{:.2f}", channel.rate_hz()), channel.bytes, since_start(channel.first_utime),
        since_start(channel.last_utime), remarks_of(channel));
  }
}

void print_trouble(const LogSummary& log) {
  if (!log.trouble.empty()) std::cerr << "the log is " << log.trouble << '\n';
  for (const auto& [name, channel] : log.channels) {
    if (channel.damaged()) std::cerr << printable(name) << ": " << printable(channel.first_fault) << '\n';
  }
}

}  // namespace

int run_info(const InfoOptions& options) {
  LogReader reader(options.log);
  const LogSummary log = summarize(reader);
  if (options.json) {
    std::cout << to_json(options.log, log).dump(2) << '\n';
  } else {
    print_table(options.log, log);
  }
  print_trouble(log);
  return log.damaged() ? 1 : 0;
}

}  // namespace scanway::tools
