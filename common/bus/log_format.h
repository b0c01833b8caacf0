#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace scanway::log_format {

// LCM's event log: events and nothing else. An event is a header of 28 bytes, all big-endian (sync word, event number
// (8), time in us (8), length of the channel's name, length of the data), the channel's name, and the data.
inline constexpr std::size_t kHeaderBytes = 28;
inline constexpr std::array<std::uint8_t, 4> kSync = {0xED, 0xA1, 0xDA, 0x01};
inline constexpr std::size_t kNumberAt = 4;
inline constexpr std::size_t kUtimeAt = 12;
inline constexpr std::size_t kChannelLengthAt = 20;
inline constexpr std::size_t kDataLengthAt = 24;
/// LCM's own reader takes channel names shorter than this; its publishers none longer than kMaxChannelBytes.
inline constexpr std::uint32_t kChannelLengthEnd = 1000;
inline constexpr std::size_t kMaxChannelBytes = 63;

/// `Unsigned`: std::uint32_t or std::uint64_t.
template <class Unsigned>
Unsigned get(const std::uint8_t* at) {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) value = value << 8 | at[i];
  return value;
}

template <class Unsigned>
void put(Unsigned value, std::uint8_t* at) {
  for (std::size_t i = sizeof(Unsigned); i-- > 0; value >>= 8) at[i] = static_cast<std::uint8_t>(value);
}

}  // namespace scanway::log_format
