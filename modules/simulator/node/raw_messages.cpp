#include "modules/simulator/node/raw_messages.h"

#include <limits>

#include "common/math/angle.h"
#include "common/messages/rigid.h"

namespace scanway::simulator {
namespace {

constexpr int kBeamsOfPiece = 290;  // 99 bytes and 4 a beam.

// The scanner counts its angles from its right; `laser` has x ahead.
constexpr double kDeviceAhead = radians(90);

laser_line_t line_header(const RawSweep& raw, int row, const SweepNumbers& numbers) {
  const ScanPattern& pattern = raw.pattern;
  laser_line_t line{};
  line.utime = pattern.line_utime(raw.line_of(row));
  line.line = numbers.first_line + row;
  line.numbered_since = numbers.numbered_since;
  line.device_time_us = (line.utime - numbers.numbered_since) & 0xFFFFFFFF;
  line.beam_period_us = pattern.beam_period_us() * raw.thin;
  line.start_angle_rad = pattern.first_angle() + kDeviceAhead;
  line.angle_step_rad = pattern.angle_step() * raw.thin;
  line.range_scale_m = static_cast<float>(raw.range_scale_m);
  line.rssi_scale = 1.0F;
  line.nbeams_of_line = raw.beams;
  return line;
}

}  // namespace

std::vector<laser_line_t> line_messages(const RawSweep& raw, int row, const SweepNumbers& numbers) {
  std::vector<laser_line_t> pieces;
  const int count = (raw.beams + kBeamsOfPiece - 1) / kBeamsOfPiece;
  for (int i = 0; i < count; ++i) {
    laser_line_t piece = line_header(raw, row, numbers);
    const int begin = raw.beams * i / count, end = raw.beams * (i + 1) / count;
    piece.first_beam = begin;
    piece.nbeams = piece.nrssi = end - begin;
    for (int column = begin; column < end; ++column) {
      piece.range_count.push_back(static_cast<std::int16_t>(raw.reading(row, column).range_count));
      piece.rssi_count.push_back(raw.reading(row, column).rssi_count);
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

sweep_mark_t mark_message(const ScanPattern& pattern, std::int8_t mark, const SweepNumbers& numbers) {
  sweep_mark_t message{};
  const bool started = mark == sweep_mark_t::STARTED;
  message.utime = started ? pattern.start() : pattern.end();
  message.sweep = numbers.sweep;
  message.numbered_since = numbers.numbered_since;
  message.mark = mark;
  message.pan_rad = started ? pattern.pan_start() : pattern.pan_end();
  message.tilt_rad = pattern.tilt();
  message.pan_speed_rad_s = pattern.pan_speed();
  message.sweep_angle_rad = pattern.pan_end() - pattern.pan_start();
  return message;
}

bot_core::joint_state_t joint_message(const ScanPattern& pattern, Utime utime) {
  const bool turning = utime >= pattern.start() && utime < pattern.end();
  const double pan = pattern.pan_angle(static_cast<double>(utime - pattern.start()));
  constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
  bot_core::joint_state_t message{};
  message.utime = utime;
  message.num_joints = 2;
  message.joint_name = {"pan", "tilt"};
  message.joint_position = {static_cast<float>(pan), static_cast<float>(pattern.tilt())};
  message.joint_velocity = {turning ? static_cast<float>(pattern.pan_speed()) : 0.0F, 0.0F};
  message.joint_effort = {kUnknown, kUnknown};
  return message;
}

bot_core::ins_t tracker_message(const TrackerReading& reading, std::int64_t number, Utime utime) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  bot_core::ins_t message{};
  message.utime = utime;
  message.device_time = number;
  for (int i = 0; i < 3; ++i) {
    message.gyro[i] = reading.gyro[i];
    message.accel[i] = reading.accel[i];
    message.mag[i] = kUnknown;
  }
  put_quaternion(reading.R_world_base, message.quat);
  message.pressure = message.rel_alt = kUnknown;
  return message;
}

}  // namespace scanway::simulator
