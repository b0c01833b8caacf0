#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace scanway {

/// A data frame of CAN 2.0A: an identifier of 11 bits and up to 8 bytes.
struct CanFrame {
  std::uint16_t id = 0;
  std::uint8_t size = 0;  ///< 0 to 8.
  std::array<std::uint8_t, 8> data{};

  std::span<const std::uint8_t> bytes() const { return {data.data(), size}; }
  bool operator==(const CanFrame&) const = default;
};

}  // namespace scanway
