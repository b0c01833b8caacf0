#pragma once

#include <cstdint>

namespace scanway::planning {

/// All that a search knows of a cell, in one word: looking at a neighbour costs one line of the cache. From the lowest
/// bit: 8 how it hangs on the tree, 14 weight, 2 class (terrain.h), 40 value. The value is stored as its complement, so
/// that memory that was never touched holds infinity, and of two words the larger has the lower value.
struct CellWord {
  static constexpr int kFieldShift = 8;
  static constexpr int kValueShift = 24;
  static constexpr std::uint64_t kInfinite = (std::uint64_t{1} << (64 - kValueShift)) - 1;
  static constexpr std::uint64_t kBelowValue = (std::uint64_t{1} << kValueShift) - 1;

  std::uint64_t bits = 0;

  std::uint64_t value() const { return ~bits >> kValueShift; }
  std::uint8_t tag() const { return static_cast<std::uint8_t>(bits); }
  std::uint16_t field() const { return static_cast<std::uint16_t>(bits >> kFieldShift); }
  void set_value(std::uint64_t value) { bits = with_value(value).bits | (bits & kBelowValue); }
  void set_tag(std::uint8_t tag) { bits = (bits & ~std::uint64_t{0xFF}) | tag; }
  void set_field(std::uint16_t field) {
    bits = (bits & ~(std::uint64_t{0xFFFF} << kFieldShift)) | std::uint64_t{field} << kFieldShift;
  }

  /// A word that is larger than those, and only those, whose value is higher.
  static CellWord with_value(std::uint64_t value) { return {~value << kValueShift}; }
};

}  // namespace scanway::planning
