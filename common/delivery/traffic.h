#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

namespace scanway {

/// Counts messages by channel. Thread-safe.
class Traffic {
 public:
  using Counts = std::map<std::string, std::int64_t, std::less<>>;

  void count(std::string_view channel) {
    const std::lock_guard lock(mutex_);
    const auto known = counts_.find(channel);
    ++(known != counts_.end() ? known : counts_.emplace(channel, 0).first)->second;
  }
  Counts counts() const {
    const std::lock_guard lock(mutex_);
    return counts_;
  }

 private:
  mutable std::mutex mutex_;
  Counts counts_;
};

}  // namespace scanway
