#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace scanway::registration {

/// Points in metres relative to the sensor's centre: single precision is exact to 4 um at 80 m there, wherever the scan
/// itself may lie.
using Points = std::vector<Eigen::Vector3f>;

/// A cell of a regular grid as one number whose order is z, then y, then x: 21 bits each, cells from -2^20 to 2^20 - 1.
using CellKey = std::uint64_t;
constexpr std::int32_t kCellLimit = 1 << 20;

constexpr CellKey cell_key(std::int32_t x, std::int32_t y, std::int32_t z) {
  return static_cast<CellKey>(z + kCellLimit) << 42 | static_cast<CellKey>(y + kCellLimit) << 21 |
         static_cast<CellKey>(x + kCellLimit);
}

/// floor(value) as an integer, for |value| < 2^30 (std::floor is a call on plain x86-64).
inline std::int32_t floor_to_int(float value) {
  const auto truncated = static_cast<std::int32_t>(value);
  return truncated - (static_cast<float>(truncated) > value ? 1 : 0);
}

/// A good mixing of a cell's number for a table of 2^k slots (Stafford's variant 13 of the MurmurHash3 finaliser).
inline std::uint64_t mix(CellKey key) {
  key = (key ^ (key >> 30)) * 0xBF58476D1CE4E5B9ull;
  key = (key ^ (key >> 27)) * 0x94D049BB133111EBull;
  return key ^ (key >> 31);
}

}  // namespace scanway::registration
