#include "modules/replay/verify/sweep_list.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "common/files/printable.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "common/messages/sweep_message.h"
#include "scanway/cloud_tile_t.hpp"
#include "scanway/cost_map_index_t.hpp"
#include "scanway/cost_tile_t.hpp"
#include "scanway/laser_line_t.hpp"
#include "scanway/octomap_t.hpp"

namespace scanway {
namespace {

/// What the log holds of one input channel of a sweep.
struct FoundInput {
  std::vector<RecordedLog::Bytes> messages;
  std::string missing;  ///< Empty: nothing.
};

std::string_view text_of_bytes(RecordedLog::Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// What an assembler has use for: of LASER_LINE the first echo.
bool is_usable(std::string_view channel, RecordedLog::Bytes message) {
  return channel != channel::kLaserLine.name || decode<laser_line_t>(message).echo == 0;
}

/// The one message, or all messages of the span in the order of their times, then of their bytes: whichever has the
/// digest.
FoundInput find_input(const RecordedLog& log, const input_span_t& input) {
  if (input.used_count <= 0) return {};
  const auto& all = log.messages(input.channel);
  const auto first = all.lower_bound(input.first_utime), end = all.upper_bound(input.last_utime);
  std::vector<std::pair<Utime, RecordedLog::Bytes>> in_order;
  for (auto one = first; one != end; ++one) {
    if (input.used_count > 1 && is_usable(input.channel, one->second)) in_order.push_back(*one);
    if (input.used_count == 1 && static_cast<std::int64_t>(digest(one->second)) == input.used_digest) {
      return {{one->second}, {}};
    }
  }
  std::ranges::sort(in_order, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : text_of_bytes(a.second) < text_of_bytes(b.second);
  });
  std::vector<RecordedLog::Bytes> messages;
  std::vector<std::uint8_t> together;
  for (const auto& [utime, message] : in_order) {
    messages.push_back(message);
    together.insert(together.end(), message.begin(), message.end());
  }
  if (input.used_count > 1 && static_cast<std::int64_t>(digest(together)) == input.used_digest) return {messages, {}};
  if (input.used_count == 1) {
    return {{}, fmt::format("{} at {} digest {}", printable(input.channel), input.first_utime, hex(input.used_digest))};
  }
  return {{},
          fmt::format("{} from {} to {} digest {}: {} messages, the log holds {}", printable(input.channel),
                      input.first_utime, input.last_utime, hex(input.used_digest), input.used_count, messages.size())};
}

/// The object on SWEEP with that digest, whatever its key: whole and sound, or why not.
struct FoundSweep {
  const RecordedObject* whole = nullptr;
  std::string fault;    ///< What is there is not what was sent.
  std::string lacking;  ///< Pieces, or all of it.
};

FoundSweep find_sweep(const RecordedLog& log, const sweep_inputs_t& listed) {
  for (const auto& [name, object] : log.objects_of(channel::kSweep)) {
    if (name.digest != listed.sweep_digest) continue;
    if (!object.whole()) return {nullptr, "", object.lacking()};
    if (!object.fault().empty()) return {nullptr, object.fault(), ""};
    return {&object, "", ""};
  }
  return {nullptr, "", "all of it"};
}

/// Why the list cannot be of that sweep; empty: it can.
std::string contradiction(const sweep_inputs_t& listed, const RecordedObject& object) {
  const auto sweep = decode<Sweep>(object.bytes().value());
  if (sweep.utime == listed.utime && sweep.name == listed.sweep_name) return {};
  return fmt::format("SWEEP_INPUTS of {} at {} is not of the sweep that it names, {} at {}",
                     printable(listed.sweep_name), listed.utime, printable(sweep.name), sweep.utime);
}

/// Finds the sweep itself. Where it is made of lines that the log holds, it is no input: if pieces of it are lacking,
/// its digest, which is listed, is compared all the same.
void take_sweep(const RecordedLog& log, const sweep_inputs_t& listed, ListedSweep& sweep, SweepList& list) {
  const FoundSweep found = find_sweep(log, listed);
  const std::string name =
      fmt::format("SWEEP {} at {} digest {}", printable(listed.sweep_name), listed.utime, hex(listed.sweep_digest));
  sweep.sweep = found.whole;
  if (found.whole != nullptr) {
    if (list.difference.empty()) list.difference = contradiction(listed, *found.whole);
  } else if (sweep.complete && sweep.is_assembled() && found.fault.empty()) {
    list.notes.push_back(fmt::format("compared by its digest alone: {}: lacks {}", name, found.lacking));
  } else {
    list.missing.push_back(name + ": " + (found.fault.empty() ? found.lacking : found.fault));
    sweep.complete = false;
  }
}

/// The version of the map that the sweep made, as a product of it says that is whole; 0 if there is none.
std::int64_t map_version_at(const RecordedLog& log, Utime sweep) {
  for (const RecordedName& name : log.products_at(sweep)) {
    const auto object = log.objects().find(name);
    if (object == log.objects().end() || !object->second.whole() || !object->second.fault().empty()) continue;
    const auto bytes = object->second.bytes().value();
    if (name.channel == channel::kCostMapTile.name) return decode<cost_tile_t>(bytes).map_version;
    if (name.channel == channel::kCostMapIndex.name) return decode<cost_map_index_t>(bytes).map_version;
    if (name.channel == channel::kCloudTile.name) return decode<cloud_tile_t>(bytes).map_version;
    if (name.channel == channel::kOctomap.name) return decode<octomap_t>(bytes).map_version;
  }
  return 0;
}

void find_what_is_not_listed(const RecordedLog& log, std::optional<Utime> continued, SweepList& list) {
  std::set<Utime> listed;
  if (continued) listed.insert(*continued);
  for (const ListedSweep& sweep : list.sweeps) listed.insert(sweep.utime);
  for (const Utime sweep : log.sweeps()) {
    if (listed.contains(sweep)) continue;
    list.not_listed.push_back(sweep);
    list.missing.push_back(fmt::format("SWEEP_INPUTS at {}: the log holds {} of that sweep", sweep,
                                       text_of(log.products_at(sweep).front())));
  }
  std::int64_t count = static_cast<std::int64_t>(list.not_listed.size()) + (continued ? 1 : 0);
  for (ListedSweep& sweep : list.sweeps) {
    const std::int64_t version = map_version_at(log, sweep.utime);
    if (version <= ++count) continue;
    list.missing.push_back(fmt::format("SWEEP_INPUTS before {}: that sweep made map version {}, and the log lists {}",
                                       sweep.utime, version, count));
    list.not_listed.push_back(sweep.utime - 1);
    return;
  }
}

}  // namespace

bool ListedSweep::is_assembled() const {
  return std::ranges::any_of(messages, [](const auto& message) { return message.first == channel::kLaserLine.name; });
}

std::string missing_input(const RecordedLog& log, const input_span_t& input) { return find_input(log, input).missing; }

SweepList list_sweeps(const RecordedLog& log, std::optional<Utime> continued) {
  SweepList list;
  std::set<std::pair<Utime, std::int64_t>> known;
  for (const sweep_inputs_t& listed : log.sweep_inputs()) {
    if (!known.emplace(listed.utime, listed.sweep_digest).second) {
      list.difference = fmt::format("the log holds two different SWEEP_INPUTS of {} at {}",
                                    printable(listed.sweep_name), listed.utime);
      continue;
    }
    ListedSweep sweep{listed.utime, listed.sweep_name, {}, nullptr, true};
    for (const input_span_t& input : listed.inputs) {
      const FoundInput found = find_input(log, input);
      for (const auto& message : found.messages) sweep.messages.emplace_back(input.channel, message);
      sweep.complete = sweep.complete && found.missing.empty();
      if (!found.missing.empty()) list.missing.push_back(found.missing);
    }
    take_sweep(log, listed, sweep, list);
    list.sweeps.push_back(std::move(sweep));
  }
  find_what_is_not_listed(log, continued, list);
  return list;
}

}  // namespace scanway
