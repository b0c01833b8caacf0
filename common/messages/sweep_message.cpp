#include "common/messages/sweep_message.h"

#include <cmath>
#include <limits>

#include "common/messages/bad_message.h"

namespace scanway {

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

}  // namespace scanway
