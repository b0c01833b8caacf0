#include "modules/mapper/core/movement/direction_times.h"

#include <algorithm>
#include <cmath>

#include "common/math/repeatable.h"

namespace scanway {
namespace {

constexpr std::size_t kBins = 720, kSamples = 200'000;
constexpr float kSteepest = 3.0f;             // height over distance: steeper beams cross the azimuths
constexpr float kNearest = 0.5f;              // metres: nearer, the mirror's way about the axis shows
constexpr std::int32_t kLongest = 3'000'000;  // microseconds that a bin is looked at, in one passage

std::optional<std::size_t> bin_of(const Eigen::Vector3f& d) {
  const float across = d.head<2>().norm();
  if (!(across > kNearest) || std::fabs(d.z()) > kSteepest * across) return std::nullopt;
  const double turn = repeatable::atan2(d.y(), d.x()) / (2.0 * repeatable::kPi) + 0.5;
  return std::min(kBins - 1, static_cast<std::size_t>(turn * kBins));
}

}  // namespace

DirectionTimes::DirectionTimes(const Sweep& sweep) : spans_(kBins) {
  const auto& times = sweep.time_offset_us;
  if (times.empty() || times.size() != sweep.cloud.size()) return;
  const auto [first, last] = std::minmax_element(times.begin(), times.end());
  begin_ = *first;
  duration_s_ = 1e-6 * (static_cast<double>(*last) - static_cast<double>(*first));
  const std::size_t stride = std::max<std::size_t>(1, times.size() / kSamples);
  for (std::size_t i = 0; i < times.size(); i += stride) {
    const auto bin = bin_of(sweep.cloud.points[i] - sweep.origin.cast<float>());
    if (!bin) continue;
    Span& span = spans_[*bin];
    const bool is_new = span.first > span.last;
    span.first = is_new ? times[i] : std::min(span.first, times[i]);
    span.last = is_new ? times[i] : std::max(span.last, times[i]);
  }
}

std::optional<double> DirectionTimes::at(const Eigen::Vector3f& direction) const {
  const auto bin = bin_of(direction);
  if (!known() || !bin) return std::nullopt;
  const Span& span = spans_[*bin];
  if (span.first > span.last || span.last - span.first > kLongest) return std::nullopt;
  return 0.5e-6 * (static_cast<double>(span.first - begin_) + static_cast<double>(span.last - begin_));
}

}  // namespace scanway
