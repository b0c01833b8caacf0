#include "common/delivery/spacing.h"

#include <algorithm>

namespace scanway {
namespace {

constexpr Utime kLongestInterval = 10 * kMicrosecondsPerSecond;
constexpr std::size_t kAlike = 20;  // Of the intervals that are remembered; a lossy link makes longer ones.

}  // namespace

std::int64_t Spacing::add(Utime utime) {
  // As unsigned numbers: times are whatever messages say, and their difference may overflow.
  const auto elapsed = static_cast<std::uint64_t>(utime) - static_cast<std::uint64_t>(last_);
  const bool later = !begun_ || utime > last_;
  const bool first = !begun_;
  if (!later) return 0;  // Repeated, or overtaken by a newer one, which was counted.
  begun_ = true;
  last_ = utime;
  if (first || elapsed > static_cast<std::uint64_t>(kLongestInterval)) return 0;  // Begun anew.
  const auto interval = static_cast<Utime>(elapsed);
  const Utime expected = usual();
  intervals_[known_++ % kRemembered] = interval;
  const std::int64_t gap = expected > 0 && 2 * interval > 3 * expected ? (interval + expected / 2) / expected - 1 : 0;
  missing_ += gap;
  return gap;
}

Utime Spacing::usual() const {
  if (known_ < kRemembered) return 0;
  auto sorted = intervals_;
  std::sort(sorted.begin(), sorted.end());
  const Utime median = sorted[kRemembered / 2];
  const auto alike = std::count_if(sorted.begin(), sorted.end(), [median](Utime interval) {
    return 4 * std::max(interval - median, median - interval) <= median;
  });
  return static_cast<std::size_t>(alike) >= kAlike ? median : 0;
}

}  // namespace scanway
