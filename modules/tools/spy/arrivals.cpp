#include "modules/tools/spy/arrivals.h"

#include <algorithm>
#include <cmath>

namespace scanway::tools {
namespace {

constexpr double kMicrosecond = 1e-6;
constexpr double kSilentAfterIntervals = 3.0;
constexpr double kSilentAfterS = 2.0;

}  // namespace

void Arrivals::add(SteadyTime now, std::size_t bytes) {
  arrivals_.push_back({now, bytes});
  bytes_ += bytes;
  const auto outdated = [&] {
    return arrivals_.size() > kMost || (arrivals_.size() > kLeast && now - arrivals_.front().time > window_);
  };
  while (outdated()) {
    bytes_ -= arrivals_.front().bytes;
    arrivals_.pop_front();
  }
}

double Arrivals::per_second(double amount, SteadyTime now) const {
  if (arrivals_.size() < 2) return 0.0;
  const double span_s = static_cast<double>(arrivals_.back().time - arrivals_.front().time) * kMicrosecond;
  const double interval_s = span_s / static_cast<double>(arrivals_.size() - 1);
  if (span_s <= 0.0 || age_s(now) > std::max(kSilentAfterS, kSilentAfterIntervals * interval_s)) return 0.0;
  return amount / span_s;
}

double Arrivals::rate_hz(SteadyTime now) const { return per_second(static_cast<double>(arrivals_.size()) - 1.0, now); }

double Arrivals::bytes_per_s(SteadyTime now) const {
  return arrivals_.empty() ? 0.0 : per_second(static_cast<double>(bytes_ - arrivals_.front().bytes), now);
}

std::optional<double> Arrivals::jitter_s() const {
  if (arrivals_.size() < 3) return std::nullopt;
  const auto intervals = static_cast<double>(arrivals_.size() - 1);
  const double mean = static_cast<double>(arrivals_.back().time - arrivals_.front().time) / intervals;
  double squares = 0.0;
  for (std::size_t i = 1; i < arrivals_.size(); ++i) {
    const double off = static_cast<double>(arrivals_[i].time - arrivals_[i - 1].time) - mean;
    squares += off * off;
  }
  return std::sqrt(squares / intervals) * kMicrosecond;
}

double Arrivals::age_s(SteadyTime now) const {
  return arrivals_.empty() ? 0.0 : static_cast<double>(now - arrivals_.back().time) * kMicrosecond;
}

}  // namespace scanway::tools
