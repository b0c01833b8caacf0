#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace scanway {

/// An object's bytes, packed for the way.
struct Packed {
  std::int8_t coding = 0;  ///< One of piece_t's.
  std::vector<std::uint8_t> bytes;
};

/// The same bytes always pack in the same way.
Packed pack(std::span<const std::uint8_t> object);

/// The object again, or nothing if `packed` does not unpack to exactly `total_bytes`. However it is made, no more than
/// twice these and zstd's own book-keeping (some 160 kB) is allocated.
std::optional<std::vector<std::uint8_t>> unpack(const Packed& packed, std::size_t total_bytes);

}  // namespace scanway
