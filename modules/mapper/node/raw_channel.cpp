#include "modules/mapper/node/raw_channel.h"

#include <iterator>

#include "common/messages/digest.h"

namespace scanway {

bool RawChannel::add(Utime utime, std::span<const std::uint8_t> bytes) {
  if (!messages_.emplace(utime, std::vector<std::uint8_t>(bytes.begin(), bytes.end())).second) return false;
  bytes_ += bytes.size();
  while (bytes_ > most_bytes_) {
    bytes_ -= messages_.begin()->second.size();
    messages_.erase(messages_.begin());
  }
  return true;
}

void RawChannel::forget_before(Utime utime) {
  while (!messages_.empty() && messages_.begin()->first < utime) {
    bytes_ -= messages_.begin()->second.size();
    messages_.erase(messages_.begin());
  }
}

RawChannel::Messages RawChannel::from_to(Utime first, Utime last) const {
  Messages found;
  for (auto one = messages_.lower_bound(first); one != messages_.end() && one->first <= last; ++one) {
    found.push_back(&*one);
  }
  return found;
}

RawChannel::Messages RawChannel::around(Utime first, Utime last) const {
  const auto begin = messages_.lower_bound(first);
  const Utime before = begin == messages_.begin() ? first : std::prev(begin)->first;
  const auto end = messages_.lower_bound(last);
  return from_to(before, end == messages_.end() ? last : end->first);
}

std::optional<Utime> RawChannel::newest() const {
  return messages_.empty() ? std::nullopt : std::optional(messages_.rbegin()->first);
}

input_span_t span_of(std::string_view channel, const RawChannel::Messages& used, std::int64_t late) {
  input_span_t span{};
  span.channel = channel;
  span.late_count = late;
  if (used.empty()) return span;
  std::vector<std::uint8_t> together;
  for (const RawChannel::Message* message : used) {
    together.insert(together.end(), message->second.begin(), message->second.end());
  }
  span.first_utime = used.front()->first;
  span.last_utime = used.back()->first;
  span.used_count = static_cast<std::int64_t>(used.size());
  span.used_digest = static_cast<std::int64_t>(digest(together));
  return span;
}

}  // namespace scanway
