#include "modules/mapper/node/raw_input.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "bot_core/ins_t.hpp"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "common/messages/imu_message.h"

namespace scanway {
namespace {

/// LCM has no integers without sign.
std::vector<std::uint16_t> counts_of(const std::vector<std::int16_t>& counts) { return {counts.begin(), counts.end()}; }

double angle_of(const bot_core::joint_state_t& message, std::string_view joint) {
  const auto found = std::find(message.joint_name.begin(), message.joint_name.end(), joint);
  if (found == message.joint_name.end()) throw BadMessage("PAN_TILT_STATE without pan and tilt");
  const double angle = message.joint_position[static_cast<std::size_t>(found - message.joint_name.begin())];
  if (!std::isfinite(angle)) throw BadMessage("PAN_TILT_STATE with an angle that is no number");
  return angle;
}

}  // namespace

LinePiece piece_of(const laser_line_t& message) {
  LinePiece piece;
  ScanLine& line = piece.line;
  line.number = message.line;
  line.utime = message.utime;
  line.beam_period_us = message.beam_period_us;
  line.start_angle_rad = message.start_angle_rad;
  line.angle_step_rad = message.angle_step_rad;
  line.range_scale_m = message.range_scale_m;
  line.range_offset_m = message.range_offset_m;
  line.rssi_scale = message.rssi_scale;
  line.rssi_offset = message.rssi_offset;
  for (const double number : {line.beam_period_us, line.start_angle_rad, line.angle_step_rad, line.range_scale_m,
                              line.range_offset_m, line.rssi_scale, line.rssi_offset}) {
    if (!std::isfinite(number)) throw BadMessage("LASER_LINE with a value that is no number");
  }
  if (line.number < 0 || line.beam_period_us < 0.0) throw BadMessage("LASER_LINE with a negative number");
  line.range_counts = counts_of(message.range_count);
  line.rssi_counts = counts_of(message.rssi_count);
  piece.numbered_since = message.numbered_since;
  piece.beams_of_line = message.nbeams_of_line;
  piece.first_beam = message.first_beam;
  return piece;
}

PanTiltAngles angles_of(const bot_core::joint_state_t& message) {
  return {message.utime, angle_of(message, "pan"), angle_of(message, "tilt")};
}

AssemblyInput assembly_input(const RawChannel::Messages& lines, const RawChannel::Messages& angles,
                             const RawChannel::Messages& imu) {
  AssemblyInput input;
  LineCollector collector;
  for (const auto* line : lines) collector.add(piece_of(decode<laser_line_t>(line->second)));
  input.lines = collector.take();
  for (const auto* state : angles) input.angles.push_back(angles_of(decode<bot_core::joint_state_t>(state->second)));
  for (const auto* one : imu) {
    const auto message = decode<bot_core::ins_t>(one->second);
    input.orientations.push_back({message.utime, orientation_of(message)});
  }
  return input;
}

}  // namespace scanway
