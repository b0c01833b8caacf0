#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "common/clock/steady_time.h"

namespace scanway::tools {

/// When a channel's last messages came, and what that says of its rate.
class Arrivals {
 public:
  /// Of the last `window`; of the last kLeast messages where these are more.
  explicit Arrivals(SteadyTime window) : window_(window) {}

  void add(SteadyTime now, std::size_t bytes);

  /// 0 when nothing came for longer than the rate would tell.
  double rate_hz(SteadyTime now) const;
  double bytes_per_s(SteadyTime now) const;
  /// Standard deviation of the time from one message to the next; nothing for fewer than three messages.
  std::optional<double> jitter_s() const;
  double age_s(SteadyTime now) const;

  static constexpr std::size_t kLeast = 10;
  static constexpr std::size_t kMost = 50'000;

 private:
  struct Arrival {
    SteadyTime time = 0;
    std::size_t bytes = 0;
  };

  /// Of the messages that are kept, from the first to the last; 0 if the channel is silent.
  double per_second(double amount, SteadyTime now) const;

  SteadyTime window_;
  std::deque<Arrival> arrivals_;
  std::size_t bytes_ = 0;  // Of arrivals_.
};

}  // namespace scanway::tools
