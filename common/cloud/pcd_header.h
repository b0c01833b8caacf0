#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/cloud/scalar_columns.h"

namespace scanway::cloud_formats {

enum class PcdData { ascii, binary, binary_compressed };

struct PcdField {
  std::string name;
  ScalarType type = ScalarType::f32;
  std::size_t count = 1;   ///< Numbers a point.
  std::size_t offset = 0;  ///< Bytes before it in a point.
  std::size_t index = 0;   ///< Numbers before it in a point.

  std::size_t bytes() const { return size_of(type) * count; }
};

/// The header of a PCD file (pointclouds.org, "The PCD file format"). VIEWPOINT is not used: a scan is read in the
/// frame that its points are stored in.
struct PcdHeader {
  std::vector<PcdField> fields;
  std::size_t point_bytes = 0;
  std::size_t point_numbers = 0;
  std::uint64_t points = 0;
  PcdData data = PcdData::ascii;
  std::size_t lines = 0;  ///< Of the header.
};

/// Reads the header and takes it off `bytes`. Throws InputError.
PcdHeader take_pcd_header(std::string_view& bytes, const std::string& file);

}  // namespace scanway::cloud_formats
