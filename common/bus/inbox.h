#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus.h"

namespace scanway {

/// Messages on their way from one thread to another, first in first out and without a limit: nothing is lost here.
class Inbox {
 public:
  struct Waiting {
    std::string channel;
    std::vector<std::uint8_t> bytes;
  };

  void push(std::string_view channel, std::span<const std::uint8_t> bytes) {
    {
      const std::lock_guard lock(mutex_);
      waiting_.push_back({std::string(channel), {bytes.begin(), bytes.end()}});
    }
    arrived_.notify_one();
  }

  /// What waits; waits up to `wait` for something to come.
  std::deque<Waiting> take(std::chrono::milliseconds wait) {
    std::unique_lock lock(mutex_);
    arrived_.wait_for(lock, wait, [this] { return !waiting_.empty(); });
    return std::exchange(waiting_, {});
  }

  std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return waiting_.size();
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<Waiting> waiting_;
};

}  // namespace scanway
