#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/bytes/frame_finder.h"

/// Packets of the ERRATIC / ERA-Mobi base: FA FB, length, payload, checksum. The length counts payload and checksum.
namespace scanway::erratic {

using Bytes = std::span<const std::uint8_t>;

/// Over the payload alone: its bytes in pairs, the first one high, summed modulo 65536; a byte left over is xor-ed in.
std::uint16_t checksum(Bytes payload);

/// The packet of a payload of 1 to 253 bytes.
std::vector<std::uint8_t> make_packet(Bytes payload);

/// What lies between length and checksum of a whole packet.
Bytes payload_of(Bytes packet);

/// Finds the whole packets in a stream of bytes.
FrameFinder make_packet_finder();

}  // namespace scanway::erratic
