#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Geometry>

#include "common/time/utime.h"
#include "modules/simulator/device/tracker/xbus.h"

namespace scanway::simulator {

/// What the tracker measures at one moment.
struct TrackerSample {
  Eigen::Quaterniond q_world_sensor = Eigen::Quaterniond::Identity();  ///< World: x east, y north, z up.
  Eigen::Vector3d acceleration{0.0, 0.0, 9.81};                        ///< m/s^2, of the ground's push, in the sensor.
  Eigen::Vector3d rate_of_turn = Eigen::Vector3d::Zero();              ///< rad/s, in the sensor.
  Eigen::Vector3d magnetic_field{0.0, 1.0, 0.0};                       ///< In the sensor; length 1 where calibrated.
};

/// Which measurement of a stream it is.
struct SampleMark {
  std::int64_t number = 0;    ///< Since it began to measure.
  std::uint16_t counter = 0;  ///< Of messages.
  Utime told = 0;             ///< By the tracker's clock.
};

/// What a tracker of some generation sends and how: its settings, and its measurements by them.
class TrackerOutput {
 public:
  virtual ~TrackerOutput() = default;

  /// To a request about settings; nothing if this generation has no such request.
  virtual std::optional<XbusBytes> answer(const XbusRequest& request) = 0;
  /// What of the Configuration message depends on them, which has 118 bytes.
  virtual void describe(XbusBytes& configuration) const = 0;
  /// Microseconds from the start to the measurement of that number; nothing when none is sent.
  virtual std::optional<Utime> time_of(std::int64_t number) const = 0;
  virtual XbusBytes message(const TrackerSample& sample, const SampleMark& mark) const = 0;
};

}  // namespace scanway::simulator
