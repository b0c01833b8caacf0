#include "modules/xsens_bridge/core/reading.h"

#include <cmath>

#include "common/math/angle.h"
#include "common/math/repeatable.h"

namespace scanway::xsens {
namespace {

constexpr double kSqrtHalf = 0.70710678118654752440;
constexpr double kMaxLengthError = 0.01;  // Of a quaternion that can still be a rotation.

const Numbers* numbers_of(std::span<const Item> items, Quantity quantity) {
  const Item* item = find_item(items, quantity);
  return item == nullptr ? nullptr : std::get_if<Numbers>(&item->value);
}

std::optional<std::uint32_t> integer_of(std::span<const Item> items, Quantity quantity) {
  const Item* item = find_item(items, quantity);
  if (item == nullptr) return std::nullopt;
  if (const auto* integer = std::get_if<std::uint32_t>(&item->value)) return *integer;
  if (const auto* field = std::get_if<BitField>(&item->value)) return field->bits;
  return std::nullopt;
}

std::optional<Eigen::Vector3d> vector_of(std::span<const Item> items, Quantity quantity) {
  const Numbers* numbers = numbers_of(items, quantity);
  if (numbers == nullptr) return std::nullopt;
  return Eigen::Vector3d((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

Eigen::Quaterniond about_axis(double degrees, int axis) {
  const double half = radians(degrees) / 2.0;
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  vector[axis] = repeatable::sin(half);
  return {repeatable::cos(half), vector.x(), vector.y(), vector.z()};
}

/// R = Rz(yaw) Ry(pitch) Rx(roll).
Eigen::Quaterniond from_euler(const Numbers& rpy_deg) {
  return about_axis(rpy_deg[2], 2) * about_axis(rpy_deg[1], 1) * about_axis(rpy_deg[0], 0);
}

Eigen::Quaterniond from_matrix(const Numbers& rows) {
  Eigen::Matrix3d R;
  R << rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7], rows[8];
  if (!((R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < kMaxLengthError) || R.determinant() < 0.0) {
    return {0.0, 0.0, 0.0, 0.0};
  }
  return Eigen::Quaterniond(R);
}

/// The rotation from the tracker's earth frame to x east, y north, z up.
Eigen::Quaterniond q_enu(EarthFrame frame) {
  switch (frame) {
    case EarthFrame::nwu:
      return {kSqrtHalf, 0.0, 0.0, kSqrtHalf};
    case EarthFrame::ned:
      return {0.0, kSqrtHalf, kSqrtHalf, 0.0};
    case EarthFrame::enu:
      break;
  }
  return Eigen::Quaterniond::Identity();
}

std::optional<Eigen::Quaterniond> orientation_of(std::span<const Item> items) {
  for (const Quantity quantity : {Quantity::quaternion, Quantity::rotation_matrix, Quantity::euler}) {
    const Numbers* numbers = numbers_of(items, quantity);
    if (numbers == nullptr) continue;
    const auto& n = *numbers;
    const Eigen::Quaterniond q = quantity == Quantity::quaternion        ? Eigen::Quaterniond(n[0], n[1], n[2], n[3])
                                 : quantity == Quantity::rotation_matrix ? from_matrix(n)
                                                                         : from_euler(n);
    // Written so that NaN is refused too.
    if (!(std::fabs(q.norm() - 1.0) < kMaxLengthError)) continue;
    return q_enu(find_item(items, quantity)->frame) * q.normalized();
  }
  return std::nullopt;
}

}  // namespace

bool TrackerReading::healthy() const {
  constexpr std::uint32_t kClipped = kClippedAcceleration | kClippedRateOfTurn | kClippedMagneticField;
  return !status || ((*status & kFilterValid) != 0 && (*status & kClipped) == 0);
}

TrackerReading make_reading(std::span<const Item> items, const TrackerAccuracy& accuracy) {
  TrackerReading reading;
  for (const Quantity counter : {Quantity::packet_counter, Quantity::sample_counter}) {
    if (const auto value = integer_of(items, counter)) reading.packet_counter = static_cast<std::uint16_t>(*value);
  }
  reading.sample_time_fine = integer_of(items, Quantity::sample_time_fine);
  reading.status = integer_of(items, Quantity::status_word);
  if (!reading.status) reading.status = integer_of(items, Quantity::status_byte);
  reading.q_world_sensor = orientation_of(items);
  const double factor = reading.healthy() ? 1.0 : kUnhealthyFactor;
  reading.tilt_sigma = factor * accuracy.tilt_sigma;
  reading.heading_sigma = factor * accuracy.heading_sigma;
  reading.acceleration = vector_of(items, Quantity::acceleration);
  reading.rate_of_turn = vector_of(items, Quantity::rate_of_turn);
  reading.magnetic_field = vector_of(items, Quantity::magnetic_field);
  if (const auto pressure = integer_of(items, Quantity::pressure)) reading.pressure_pa = *pressure;
  return reading;
}

}  // namespace scanway::xsens
