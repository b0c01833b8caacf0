#include "modules/mapper/core/assembly/angle_track.h"

#include <algorithm>
#include <utility>

#include "modules/mapper/core/assembly/delays.h"

namespace scanway {

AngleTrack::AngleTrack(std::vector<PanTiltAngles> angles, Utime longest_gap_us)
    : angles_(std::move(angles)), longest_gap_us_(longest_gap_us) {
  const auto earlier = [](const PanTiltAngles& a, const PanTiltAngles& b) { return a.utime < b.utime; };
  const auto same_time = [](const PanTiltAngles& a, const PanTiltAngles& b) { return a.utime == b.utime; };
  std::stable_sort(angles_.begin(), angles_.end(), earlier);
  angles_.erase(std::unique(angles_.begin(), angles_.end(), same_time), angles_.end());
  angles_ = without_delays(std::move(angles_), longest_gap_us_);
}

std::optional<PanTiltAngles> AngleTrack::at(double after_us) const {
  if (angles_.size() < 2 || after_us < 0.0) return std::nullopt;
  const auto next = std::upper_bound(
      angles_.begin(), angles_.end(), after_us,
      [&](double time, const PanTiltAngles& a) { return time < static_cast<double>(a.utime - start()); });
  const auto right = next == angles_.end() ? next - 1 : next;
  const auto left = right - 1;
  const auto end = static_cast<double>(right->utime - start()), begin = static_cast<double>(left->utime - start());
  if (after_us > end || right->utime - left->utime > longest_gap_us_) return std::nullopt;
  const double share = (after_us - begin) / (end - begin);
  return PanTiltAngles{left->utime, left->pan + share * (right->pan - left->pan),
                       left->tilt + share * (right->tilt - left->tilt)};
}

}  // namespace scanway
