#include "modules/sick_bridge/node/line_message.h"

#include <algorithm>
#include <string>

#include "common/math/angle.h"
#include "modules/sick_bridge/core/scan_geometry.h"

namespace scanway::sick {
namespace {

constexpr int kMaxEchoes = 5;
constexpr float kMetresPerMillimetre = 0.001F;

/// The remission of the same beams, or nullptr.
const ScanChannel* rssi_of(const Scan& scan, const ScanChannel& ranges, int echo) {
  const ScanChannel* const rssi = scan.channel("RSSI" + std::to_string(echo + 1));
  return rssi != nullptr && rssi->counts.size() == ranges.counts.size() ? rssi : nullptr;
}

/// What every piece of an echo says.
laser_line_t head_of(const Scan& scan, const ScanChannel& ranges, const ScanChannel* rssi, double beam_period_us) {
  laser_line_t head{};
  head.device_time_us = scan.start_time_us;
  head.beam_period_us = beam_period_us;
  head.start_angle_rad = radians(beam_angle_deg(ranges, 0));
  head.angle_step_rad = radians(true_step_deg(ranges.step));
  head.range_scale_m = ranges.scale * kMetresPerMillimetre;
  head.range_offset_m = ranges.offset * kMetresPerMillimetre;
  head.rssi_scale = rssi != nullptr ? rssi->scale : 1.0F;
  head.rssi_offset = rssi != nullptr ? rssi->offset : 0.0F;
  head.device_status = static_cast<std::int16_t>(scan.device_status);
  head.nbeams_of_line = static_cast<std::int32_t>(ranges.counts.size());
  return head;
}

/// LCM has no integers without sign.
std::vector<std::int16_t> part_of(const ScanChannel& channel, std::size_t first, std::size_t count) {
  const auto begin = channel.counts.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

void cut(const laser_line_t& head, const ScanChannel& ranges, const ScanChannel* rssi,
         std::vector<laser_line_t>& pieces) {
  const std::size_t bytes_a_beam = sizeof(std::int16_t) * (rssi != nullptr ? 2 : 1);
  const std::size_t most = (kMaxLineBytes - static_cast<std::size_t>(head.getEncodedSize())) / bytes_a_beam;
  for (std::size_t first = 0; first < ranges.counts.size(); first += most) {
    const std::size_t count = std::min(most, ranges.counts.size() - first);
    laser_line_t piece = head;
    piece.first_beam = static_cast<std::int32_t>(first);
    piece.nbeams = static_cast<std::int32_t>(count);
    piece.range_count = part_of(ranges, first, count);
    if (rssi != nullptr) piece.rssi_count = part_of(*rssi, first, count);
    piece.nrssi = static_cast<std::int32_t>(piece.rssi_count.size());
    pieces.push_back(std::move(piece));
  }
}

}  // namespace

std::vector<laser_line_t> line_messages(const Scan& scan, const LineNumber& number) {
  std::vector<laser_line_t> pieces;
  for (int echo = 0; echo < kMaxEchoes; ++echo) {
    const ScanChannel* const ranges = scan.channel("DIST" + std::to_string(echo + 1));
    const auto beam_period = ranges != nullptr ? beam_period_us(scan, *ranges) : std::nullopt;
    if (!beam_period) continue;
    const ScanChannel* const rssi = rssi_of(scan, *ranges, echo);
    laser_line_t head = head_of(scan, *ranges, rssi, *beam_period);
    head.utime = number.utime;
    head.line = number.line;
    head.numbered_since = number.numbered_since;
    head.echo = static_cast<std::int8_t>(echo);
    cut(head, *ranges, rssi, pieces);
  }
  return pieces;
}

bot_core::planar_lidar_t lidar_message(const Scan& scan, Utime utime) {
  bot_core::planar_lidar_t message{};
  message.utime = utime;
  const ScanChannel* const ranges = scan.channel("DIST1");
  if (ranges == nullptr) return message;
  const ScanChannel* const remission = rssi_of(scan, *ranges, 0);
  for (std::size_t beam = 0; beam < ranges->counts.size(); ++beam) {
    const auto range = range_m(*ranges, beam);
    message.ranges.push_back(range ? static_cast<float>(*range) : kNoReturn);
    if (remission != nullptr) message.intensities.push_back(static_cast<float>(rssi(*remission, beam)));
  }
  message.nranges = static_cast<std::int32_t>(message.ranges.size());
  message.nintensities = static_cast<std::int32_t>(message.intensities.size());
  message.rad0 = static_cast<float>(radians(beam_angle_deg(*ranges, 0) - kAheadDeg));
  message.radstep = static_cast<float>(radians(true_step_deg(ranges->step)));
  return message;
}

}  // namespace scanway::sick
