#include "modules/replay/verify/recorded_log.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "common/messages/codec.h"
#include "common/messages/digest.h"

namespace scanway {
namespace {

bool is_mapper_product(std::string_view channel) {
  return std::ranges::any_of(kMapperProducts, [&](const Channel* product) { return product->name == channel; });
}

bool is_derived(std::string_view channel) { return is_mapper_product(channel) || channel == channel::kPath.name; }

/// What carries and surrounds the products, and says other things each time.
bool is_never_compared(std::string_view channel) {
  return channel == channel::kMapState.name || channel == channel::kObjectIndex.name ||
         channel == channel::kPieceRequest.name || channel == channel::kHealth.name || channel == channel::kTiming.name;
}

}  // namespace

RecordedName name_of(std::string_view channel, std::span<const std::uint8_t> message) {
  RecordedName name{std::string(channel), "", utime_of(message), 0};
  if (channel != channel::kSweepInputs.name) {
    name.digest = static_cast<std::int64_t>(digest(message));
    return name;
  }
  auto inputs = decode<sweep_inputs_t>(message);
  for (input_span_t& input : inputs.inputs) input.late_count = 0;
  name.digest = static_cast<std::int64_t>(digest(encode(inputs)));
  return name;
}

RecordedLog::RecordedLog(const std::string& path) : log_(path) {
  while (const auto event = log_.next()) take(*event);
  for (auto& [name, object] : objects_) {
    object.check(*find_channel(name.channel));
    if (is_mapper_product(name.channel)) products_[object.utime()].insert(name);
  }
}

void RecordedLog::take(const LogEvent& event) {
  const Channel* const channel = find_channel(event.channel);
  if (channel == nullptr || is_never_compared(channel->name)) return;
  try {
    channel->cut ? take_piece(event) : take_message(*channel, event);
  } catch (const BadMessage& bad) {
    if (!is_derived(channel->name)) return;
    bad_messages_.push_back(fmt::format("{} (event {}): {}", channel->name, event.number, bad.what()));
  }
}

void RecordedLog::take_piece(const LogEvent& event) {
  const auto piece = decode<piece_t>(event.bytes);
  const RecordedName name{std::string(event.channel), piece.key, piece.version, piece.digest};
  objects_[name].add(piece, event.bytes);
}

void RecordedLog::take_message(const Channel& channel, const LogEvent& event) {
  check_message(find_layout(channel.type)->hash, event.bytes);
  const Utime utime = utime_of(event.bytes);
  auto& messages = messages_[std::string(channel.name)];
  const auto same = messages.equal_range(utime);
  const auto known = [&](const auto& one) { return std::ranges::equal(one.second, event.bytes); };
  if (std::any_of(same.first, same.second, known)) return;
  messages.emplace(utime, event.bytes);
  if (!is_mapper_product(channel.name)) return;
  const bool is_new = products_[utime].insert(name_of(channel.name, event.bytes)).second;
  if (is_new && channel.name == channel::kSweepInputs.name) {
    sweep_inputs_.push_back(decode<sweep_inputs_t>(event.bytes));
  }
}

std::ranges::subrange<RecordedLog::Objects::const_iterator> RecordedLog::objects_of(const Channel& channel) const {
  constexpr auto kFirst = std::numeric_limits<std::int64_t>::min();
  const auto first = objects_.lower_bound({std::string(channel.name), "", kFirst, kFirst});
  const auto others = [&](const auto& entry) { return entry.first.channel != channel.name; };
  return {first, std::find_if(first, objects_.end(), others)};
}

const std::multimap<Utime, RecordedLog::Bytes>& RecordedLog::messages(std::string_view channel) const {
  static const std::multimap<Utime, Bytes> kNone;
  const auto found = messages_.find(channel);
  return found == messages_.end() ? kNone : found->second;
}

std::vector<RecordedName> RecordedLog::products_at(Utime sweep) const {
  const auto found = products_.find(sweep);
  if (found == products_.end()) return {};
  std::vector<RecordedName> names(found->second.begin(), found->second.end());
  const auto order = [](const RecordedName& name) {
    return std::ranges::find_if(kMapperProducts, [&](const Channel* one) { return one->name == name.channel; });
  };
  std::ranges::stable_sort(names, {}, order);
  return names;
}

std::set<Utime> RecordedLog::sweeps() const {
  std::set<Utime> sweeps;
  const auto is_good = [&](const RecordedName& name) {
    const auto object = objects_.find(name);
    return object == objects_.end() || object->second.fault().empty();
  };
  for (const auto& [sweep, products] : products_) {
    if (std::ranges::any_of(products, is_good)) sweeps.insert(sweep);
  }
  return sweeps;
}

std::string RecordedLog::first_fault() const {
  for (const auto& [name, object] : objects_) {
    if (!is_mapper_product(name.channel) || object.fault().empty()) continue;
    return fmt::format("{}: {}; digest {} in the log", text_of(name), object.fault(),
                       hex(static_cast<std::uint64_t>(name.digest)));
  }
  return {};
}

bool RecordedLog::holds_derived() const { return !products_.empty() || !objects_of(channel::kPath).empty(); }

}  // namespace scanway
