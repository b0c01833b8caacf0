#include "modules/tools/spy/traffic_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/files/printable.h"

namespace scanway::tools {
namespace {

using Json = nlohmann::ordered_json;

struct Waiting {
  std::size_t objects = 0;
  std::int64_t pieces = 0;
};

Waiting waiting_of(const ChannelTraffic& channel) {
  Waiting waiting;
  if (!channel.assembler) return waiting;
  for (const IncompleteObject& object : channel.assembler->incomplete()) {
    ++waiting.objects;
    waiting.pieces += object.missing_count;
  }
  return waiting;
}

std::string type_of(const ChannelTraffic& channel) {
  if (!channel.cut) return channel.type;
  return channel.type.empty() ? "(pieces)" : channel.type + " (pieces)";
}

std::string remarks_of(const ChannelTraffic& channel) {
  std::string remarks;
  const auto add = [&](const std::string& remark) { remarks += (remarks.empty() ? "" : ", ") + remark; };
  if (channel.cut) add(fmt::format("{} {}", channel.objects, channel.objects == 1 ? "object" : "objects"));
  const Waiting waiting = waiting_of(channel);
  if (waiting.objects > 0) add(fmt::format("{} incomplete ({} pieces missing)", waiting.objects, waiting.pieces));
  if (channel.bad > 0) add(fmt::format("{} bad", channel.bad));
  return remarks;
}

std::string number(std::optional<double> value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

}  // namespace

std::string traffic_table(const Traffic& traffic, SteadyTime now) {
  std::size_t name_width = 7, type_width = 4;
  for (const auto& [name, channel] : traffic.channels()) {
    name_width = std::max(name_width, printable(name).size());
    type_width = std::max(type_width, type_of(channel).size());
  }
  std::string text;
  const auto row = [&](const auto&... cells) {
    std::string line = fmt::format("{:<{}}  {:<{}}  {:>9}  {:>8}  {:>8}  {:>11}  {:>6}  {:>10}  {}", cells...);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  };
  row("channel", name_width, "type", type_width, "messages", "age (s)", "Hz", "jitter (ms)", "gaps", "bytes/s", "");
  for (const auto& [name, channel] : traffic.channels()) {
    const auto jitter = channel.cut ? std::nullopt : channel.arrivals.jitter_s();
    const auto gaps = channel.gaps.missing();
    row(printable(name), name_width, type_of(channel), type_width, channel.messages,
        number(channel.arrivals.age_s(now), 1), number(channel.arrivals.rate_hz(now), 1),
        number(jitter ? std::optional(*jitter * 1e3) : std::nullopt, 2), gaps ? std::to_string(*gaps) : "-",
        number(channel.arrivals.bytes_per_s(now), 0), remarks_of(channel));
  }
  for (const auto& [name, channel] : traffic.channels()) {
    if (channel.bad > 0) text += fmt::format("bad on {}: {}\n", printable(name), printable(channel.last_fault));
  }
  if (traffic.ignored() > 0) text += fmt::format("{} messages on further channels\n", traffic.ignored());
  return text;
}

Json traffic_json(const Traffic& traffic, SteadyTime now) {
  Json channels = Json::array();
  for (const auto& [name, channel] : traffic.channels()) {
    const auto jitter = channel.arrivals.jitter_s();
    const auto gaps = channel.gaps.missing();
    const Waiting waiting = waiting_of(channel);
    channels.push_back({{"channel", printable(name)},
                        {"type", channel.type},
                        {"cut", channel.cut},
                        {"messages", channel.messages},
                        {"bytes", channel.bytes},
                        {"age_s", channel.arrivals.age_s(now)},
                        {"rate_hz", channel.arrivals.rate_hz(now)},
                        {"jitter_s", jitter && !channel.cut ? Json(*jitter) : Json()},
                        {"gaps", gaps ? Json(*gaps) : Json()},
                        {"bytes_per_s", channel.arrivals.bytes_per_s(now)},
                        {"objects", channel.objects},
                        {"incomplete", waiting.objects},
                        {"missing_pieces", waiting.pieces},
                        {"bad", channel.bad},
                        {"fault", printable(channel.last_fault)}});
  }
  return {{"channels", channels}, {"ignored_messages", traffic.ignored()}};
}

}  // namespace scanway::tools
