#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/cloud/point_cloud.h"

namespace scanway {

/// The number types of cloud files.
enum class ScalarType { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

std::size_t size_of(ScalarType type);

/// The number at `data`, which need not be aligned.
double load_scalar(const char* data, ScalarType type, bool big_endian);

/// One number a point, every `stride` bytes.
struct ScalarColumn {
  const char* data = nullptr;
  std::size_t stride = 0;
  ScalarType type = ScalarType::f32;
  bool big_endian = false;
};

/// Where a cloud file keeps what Scanway reads of it: indices of its fields.
struct CloudFields {
  std::array<std::size_t, 3> xyz{};
  std::optional<std::size_t> intensity;
};

/// The fields x, y and z, and the one that is an intensity by its name. Throws InputError with `file` if a coordinate
/// is missing or there twice.
CloudFields choose_fields(const std::vector<std::string>& names, const std::string& file);

/// `count` points from their columns; `intensity` may be null.
PointCloud gather_columns(std::size_t count, const std::array<ScalarColumn, 3>& xyz, const ScalarColumn* intensity);

}  // namespace scanway
