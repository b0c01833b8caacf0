#include "modules/simulator/device/lms/scan_content.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace scanway::simulator {

ScanContent ScanContent::read(HostValues& values) {
  ScanContent content;
  content.channels = values.bits();
  content.remission = values.u8();
  content.remission_resolution = values.u8();
  content.unit = values.u8();
  content.encoders = values.bits();
  content.position = values.u8();
  content.name = values.u8();
  content.comment = values.u8();
  content.time = values.u8();
  content.every = std::max(1U, values.u16());
  return content;
}

void ScanContent::write(TelegramWriter& out) const {
  out.bits(channels).u8(remission).u8(remission_resolution).u8(unit);
  out.bits(encoders).u8(position).u8(name).u8(comment).u8(time);
  out.u16(every);
}

void add_channels(ScanTelegram& scan, const ScannedLine& line, const MirrorTurn& turn, int echoes, bool remission) {
  const auto beams = static_cast<std::size_t>(turn.sector.beams);
  ScanTelegram::Channel channel;
  channel.start_angle = turn.sector.written_start;
  channel.angular_step = static_cast<std::uint16_t>(std::lround(turn.step_deg * 1e4));
  for (int echo = 1; echo <= echoes; ++echo) {
    channel.content = "DIST" + std::to_string(echo);
    channel.scale = static_cast<float>(line.scale);
    channel.counts = echo == 1 ? line.ranges : std::vector<std::uint16_t>(beams);
    scan.ranges.push_back(channel);
    if (!remission) continue;
    channel.content = "RSSI" + std::to_string(echo);
    channel.scale = 1.0F;
    channel.counts.assign(beams, 0);
    if (echo == 1) channel.counts.assign(line.remissions.begin(), line.remissions.end());
    scan.remissions.push_back(channel);
  }
}

}  // namespace scanway::simulator
