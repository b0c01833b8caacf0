#include "common/messages/sweep_message.h"

#include <cmath>
#include <limits>

#include "common/messages/bad_message.h"
#include "scanway/full_sweep_t.hpp"

namespace scanway {
namespace {

full_sweep_t to_full_message(const Sweep& sweep) {
  full_sweep_t message{};
  message.sweep = to_message(sweep);
  message.nfans = static_cast<std::int32_t>(sweep.no_return.size());
  for (const BeamFan& fan : sweep.no_return) {
    message.first_x.push_back(fan.first[0]);
    message.first_y.push_back(fan.first[1]);
    message.first_z.push_back(fan.first[2]);
    message.last_x.push_back(fan.last[0]);
    message.last_y.push_back(fan.last[1]);
    message.last_z.push_back(fan.last[2]);
    message.beams.push_back(fan.beams);
  }
  return message;
}

bool is_unit(const BeamFan::Direction& d) {
  const double length = Eigen::Vector3d(d[0], d[1], d[2]).norm() / 32767.0;
  return length > 0.999 && length < 1.001;
}

bool is_fan(const BeamFan& fan) {
  if (fan.beams < 1 || !is_unit(fan.first) || !is_unit(fan.last)) return false;
  return (fan.direction(0) - fan.direction(fan.beams - 1)).norm() < kWidestFan_rad + 0.001;
}

std::vector<BeamFan> to_fans(const full_sweep_t& message) {
  std::vector<BeamFan> fans;
  fans.reserve(message.beams.size());
  for (std::size_t i = 0; i < message.beams.size(); ++i) {
    fans.push_back({{message.first_x[i], message.first_y[i], message.first_z[i]},
                    {message.last_x[i], message.last_y[i], message.last_z[i]},
                    message.beams[i]});
    if (!is_fan(fans.back())) throw BadMessage("a sweep with beams that have no direction");
  }
  return fans;
}

}  // namespace

sweep_t to_message(const Sweep& sweep) {
  sweep_t message{};
  message.utime = sweep.utime;
  message.name = sweep.name;
  for (int i = 0; i < 3; ++i) message.origin[i] = sweep.origin[i];
  message.sensor_height_m = sweep.sensor_height_m.value_or(std::numeric_limits<double>::quiet_NaN());
  const std::size_t n = sweep.cloud.size();
  message.npoints = static_cast<std::int32_t>(n);
  message.x.resize(n);
  message.y.resize(n);
  message.z.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    message.x[i] = sweep.cloud.points[i].x();
    message.y[i] = sweep.cloud.points[i].y();
    message.z[i] = sweep.cloud.points[i].z();
  }
  message.nintensities = static_cast<std::int32_t>(sweep.cloud.intensity.size());
  message.intensity = sweep.cloud.intensity;
  message.noffsets = static_cast<std::int32_t>(sweep.time_offset_us.size());
  message.time_offset_us = sweep.time_offset_us;
  return message;
}

Sweep to_sweep(const sweep_t& message) {
  const auto none_or_all = [&](std::int32_t n) { return n == 0 || n == message.npoints; };
  if (!none_or_all(message.nintensities)) throw BadMessage("a sweep with more or fewer intensities than points");
  if (!none_or_all(message.noffsets)) throw BadMessage("a sweep with more or fewer time offsets than points");
  Sweep sweep;
  sweep.name = message.name;
  sweep.utime = message.utime;
  sweep.origin = {message.origin[0], message.origin[1], message.origin[2]};
  if (!sweep.origin.allFinite()) throw BadMessage("a sweep whose origin is not finite");
  if (std::isinf(message.sensor_height_m)) throw BadMessage("a sweep with an infinite sensor height");
  if (!std::isnan(message.sensor_height_m)) sweep.sensor_height_m = message.sensor_height_m;
  const std::size_t n = message.x.size();
  sweep.cloud.points.resize(n);
  for (std::size_t i = 0; i < n; ++i) sweep.cloud.points[i] = {message.x[i], message.y[i], message.z[i]};
  sweep.cloud.intensity = message.intensity;
  sweep.time_offset_us = message.time_offset_us;
  return sweep;
}

std::vector<std::uint8_t> encode(const Sweep& sweep) {
  return sweep.no_return.empty() ? encode(to_message(sweep)) : encode(to_full_message(sweep));
}

template <>
Sweep decode<Sweep>(std::span<const std::uint8_t> bytes) {
  if (fingerprint(bytes) != full_sweep_t::getHash()) return to_sweep(decode<sweep_t>(bytes));
  const auto message = decode<full_sweep_t>(bytes);
  Sweep sweep = to_sweep(message.sweep);
  sweep.no_return = to_fans(message);
  return sweep;
}

}  // namespace scanway
