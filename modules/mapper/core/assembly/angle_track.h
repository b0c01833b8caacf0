#pragma once

#include <optional>
#include <vector>

#include "modules/mapper/core/assembly/scan_line.h"

namespace scanway {

/// The angles of the pan-tilt at any time, from those that it told: of an even turn without their delays.
class AngleTrack {
 public:
  /// `angles` in any order; of two with the same time the first counts. Between two that are farther apart than
  /// `longest_gap_us` nothing is known.
  explicit AngleTrack(std::vector<PanTiltAngles> angles, Utime longest_gap_us);

  /// By straight lines between the neighbours; nothing before the first, after the last and in a gap. `after`: the time
  /// less start() in microseconds, which has fractions.
  std::optional<PanTiltAngles> at(double after_us) const;

  bool empty() const { return angles_.empty(); }
  /// When the first was told; 0 without any.
  Utime start() const { return angles_.empty() ? 0 : angles_.front().utime; }

 private:
  std::vector<PanTiltAngles> angles_;
  Utime longest_gap_us_;
};

}  // namespace scanway
