#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <Eigen/Geometry>

#include "common/math/angle.h"
#include "modules/xsens_bridge/core/item.h"

namespace scanway::xsens {

/// Bits of the status word; the status byte is its lower eight.
enum StatusBits : std::uint32_t {
  kSelfTestOk = 1U << 0,
  kFilterValid = 1U << 1,
  kGnssFix = 1U << 2,
  kClippedAcceleration = 7U << 8,
  kClippedRateOfTurn = 7U << 11,
  kClippedMagneticField = 7U << 14,
};

/// How good the orientation of a healthy tracker is where it sits: radians, one sigma. These are a data sheet's.
struct TrackerAccuracy {
  double tilt_sigma = radians(0.5L);
  double heading_sigma = radians(1);
};

/// What one message measured, in one convention whatever the tracker's. What it does not hold is nothing.
struct TrackerReading {
  std::optional<std::uint16_t> packet_counter;    ///< +1 a message, wraps.
  std::optional<std::uint32_t> sample_time_fine;  ///< 0.1 ms on the device's clock; not monotone over messages.
  /// Rotates a vector of the sensor into a world with z up; its heading is the tracker's own (0: x east).
  std::optional<Eigen::Quaterniond> q_world_sensor;
  /// How far to trust the orientation, radians, one sigma. Without meaning where there is none.
  double tilt_sigma = 0.0;
  double heading_sigma = 0.0;
  std::optional<Eigen::Vector3d> acceleration;    ///< m/s^2, in the sensor's frame; +9.8 upward at rest.
  std::optional<Eigen::Vector3d> rate_of_turn;    ///< rad/s, in the sensor's frame.
  std::optional<Eigen::Vector3d> magnetic_field;  ///< In units of the field where it was calibrated.
  std::optional<double> pressure_pa;
  std::optional<std::uint32_t> status;  ///< Bits of StatusBits.

  /// The filter says that its orientation is valid, or says nothing; no sensor clips.
  bool healthy() const;
};

/// The reading in the items of an MTData or MTData2 message. An orientation that is none (a quaternion far from length
/// one, NaN) is left out. An unhealthy tracker's sigmas are kUnhealthyFactor times those of `accuracy`.
TrackerReading make_reading(std::span<const Item> items, const TrackerAccuracy& accuracy = {});

constexpr double kUnhealthyFactor = 10.0;

}  // namespace scanway::xsens
