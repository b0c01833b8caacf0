#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/time/utime.h"

namespace scanway {

/// A channel as the merge waits for it.
struct MergedChannel {
  std::string name;
  /// How much data time may pass before an item is given up. An item of this channel with time t comes before any item
  /// of any channel with a time later than t + bound_us; one that does not is late.
  Utime bound_us = kMicrosecondsPerSecond;
  /// Its items come in the order of their times: having one is knowing that no older one will come. Without, only
  /// bound_us says so (objects that are asked for again arrive in any order).
  bool in_order = true;
};

/// An item that came after the merge had passed its time.
struct LateItem {
  std::string channel;
  Utime utime = 0;
};

/// Merges channels by their items' own times: items leave in the order of time, those of the same time in the order in
/// which the channels were given, those of the same channel and time as they came. Nothing leaves before every other
/// channel is known to be past it, so what leaves, and in which order, does not depend on the order of arrival between
/// channels, as long as all keep their bounds. After cartographer's ordered_multi_queue, with a bound.
template <class Item>
class OrderedMerge {
 public:
  using Sink = std::function<void(std::size_t channel, Utime utime, Item&& item)>;

  /// `sink` gets each item that leaves with its channel's index among `channels`. It must not call the merge.
  OrderedMerge(std::vector<MergedChannel> channels, Sink sink) : sink_(std::move(sink)) {
    for (MergedChannel& channel : channels) {
      if (channel.bound_us < 0) throw std::invalid_argument(channel.name + ": a bound below zero");
      queues_.push_back({std::move(channel), std::nullopt, 0});
    }
  }

  /// Takes an item and lets go of all that need not wait any longer. Returns false for a late item, which is counted
  /// and dropped.
  bool add(std::size_t channel, Utime utime, Item item) {
    Queue& queue = queues_.at(channel);
    const Place place{utime, channel};
    if (passed_ && place < *passed_) {
      ++queue.late;
      last_late_ = LateItem{queue.channel.name, utime};
      return false;
    }
    queue.newest = std::max(queue.newest.value_or(utime), utime);
    newest_ = std::max(newest_.value_or(utime), utime);
    waiting_[place].push_back(std::move(item));
    release();
    return true;
  }

  /// No more items will come: everything leaves. Items that come later still must not lie before what left.
  void flush() {
    while (!waiting_.empty()) release_first();
  }

  std::uint64_t late(std::size_t channel) const { return queues_.at(channel).late; }
  const std::optional<LateItem>& last_late() const { return last_late_; }
  std::size_t waiting() const {
    std::size_t items = 0;
    for (const auto& [place, same] : waiting_) items += same.size();
    return items;
  }

 private:
  using Place = std::pair<Utime, std::size_t>;  // Time, then the channel's index.
  struct Queue {
    MergedChannel channel;
    std::optional<Utime> newest;
    std::uint64_t late = 0;
  };

  void release() {
    while (!waiting_.empty() && all_past(waiting_.begin()->first)) release_first();
  }

  bool all_past(const Place& place) const {
    for (std::size_t d = 0; d < queues_.size(); ++d) {
      if (!past(d, place)) return false;
    }
    return true;
  }

  // Whether no item of channel `d` that belongs before `place` can still come.
  bool past(std::size_t d, const Place& place) const {
    const Queue& queue = queues_[d];
    if (queue.channel.in_order && queue.newest && Place{*queue.newest, d} >= place) return true;
    // By their bounds. As unsigned numbers: times are whatever messages say, and their difference may overflow.
    const Utime time = place.first;
    return *newest_ > time && static_cast<std::uint64_t>(*newest_) - static_cast<std::uint64_t>(time) >
                                  static_cast<std::uint64_t>(queue.channel.bound_us);
  }

  void release_first() {
    const auto first = waiting_.begin();
    const Place place = first->first;
    Item item = std::move(first->second.front());
    first->second.pop_front();
    if (first->second.empty()) waiting_.erase(first);
    passed_ = place;
    sink_(place.second, place.first, std::move(item));
  }

  std::vector<Queue> queues_;
  Sink sink_;
  std::map<Place, std::deque<Item>> waiting_;
  std::optional<Place> passed_;  // Of the last item that left.
  std::optional<Utime> newest_;  // Of all channels.
  std::optional<LateItem> last_late_;
};

}  // namespace scanway
