#include "modules/base_bridge/core/packet.h"

#include <stdexcept>

namespace scanway::erratic {
namespace {

constexpr std::uint8_t kFirst = 0xFA, kSecond = 0xFB;
constexpr std::size_t kHeader = 3, kChecksum = 2, kMaxPayload = 255 - kChecksum;

FrameProbe probe(Bytes bytes) {
  if (bytes[0] != kFirst) return FrameProbe::none();
  if (bytes.size() < 2) return FrameProbe::unfinished();
  if (bytes[1] != kSecond) return FrameProbe::none();
  if (bytes.size() < kHeader) return FrameProbe::unfinished();
  if (bytes[2] <= kChecksum) return FrameProbe::broken("the length leaves no room for a payload");
  const std::size_t size = kHeader + bytes[2];
  if (bytes.size() < size) return FrameProbe::unfinished();
  const std::uint16_t given = static_cast<std::uint16_t>(bytes[size - 2] << 8 | bytes[size - 1]);
  if (given != checksum(payload_of(bytes.first(size)))) return FrameProbe::broken("wrong checksum");
  return FrameProbe::whole(size);
}

}  // namespace

std::uint16_t checksum(Bytes payload) {
  unsigned sum = 0;
  for (std::size_t i = 0; i + 1 < payload.size(); i += 2)
    sum += static_cast<unsigned>(payload[i] << 8 | payload[i + 1]);
  if (payload.size() % 2 == 1) sum = (sum & 0xFFFF) ^ payload.back();
  return static_cast<std::uint16_t>(sum & 0xFFFF);
}

std::vector<std::uint8_t> make_packet(Bytes payload) {
  if (payload.empty() || payload.size() > kMaxPayload) throw std::invalid_argument("no payload of a packet");
  std::vector<std::uint8_t> packet;
  packet.reserve(kHeader + payload.size() + kChecksum);
  for (const std::size_t byte : {std::size_t{kFirst}, std::size_t{kSecond}, payload.size() + kChecksum}) {
    packet.push_back(static_cast<std::uint8_t>(byte));
  }
  packet.insert(packet.end(), payload.begin(), payload.end());
  const std::uint16_t sum = checksum(payload);
  packet.push_back(static_cast<std::uint8_t>(sum >> 8));
  packet.push_back(static_cast<std::uint8_t>(sum & 0xFF));
  return packet;
}

Bytes payload_of(Bytes packet) { return packet.subspan(kHeader, packet.size() - kHeader - kChecksum); }

FrameFinder make_packet_finder() { return FrameFinder(probe, kFirst); }

}  // namespace scanway::erratic
