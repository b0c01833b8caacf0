#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/cloud/sweep.h"

namespace scanway {

/// When a sweep looked where, by the azimuth about the sensor. Directions that it saw at several times, as at its seam
/// and near the zenith, have none.
class DirectionTimes {
 public:
  /// Of a sweep whose points have no times, or times of no length: nothing is known.
  explicit DirectionTimes(const Sweep& sweep);

  bool known() const { return duration_s_ > 0.0; }
  double duration_s() const { return duration_s_; }
  /// Seconds since the first point, of a direction from the sensor.
  std::optional<double> at(const Eigen::Vector3f& direction) const;

 private:
  struct Span {
    std::int32_t first = 1, last = 0;  ///< Microseconds, as in the sweep; empty at first.
  };

  std::vector<Span> spans_;
  std::int32_t begin_ = 0;
  double duration_s_ = 0.0;
};

}  // namespace scanway
