#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/cloud/scalar_columns.h"

namespace scanway::cloud_formats {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::f32;          ///< Of the number, or of a list's entries.
  std::optional<ScalarType> list_count_type;  ///< Only for a list.
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_list() const;
  /// Bytes of one in a binary file; a list counts with its length alone.
  std::size_t least_bytes() const;
};

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t lines = 0;  ///< Of the header.
};

/// Reads the header (Greg Turk: The PLY Polygon File Format, 1994) and takes it off `bytes`. Throws InputError.
PlyHeader take_ply_header(std::string_view& bytes, const std::string& file);

}  // namespace scanway::cloud_formats
