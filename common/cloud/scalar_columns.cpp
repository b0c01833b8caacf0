#include "common/cloud/scalar_columns.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>

#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {
namespace {

static_assert(std::endian::native == std::endian::little);

/// By preference: a file that has several gives the first of these.
constexpr std::array<std::string_view, 9> kIntensityNames = {
    "intensity",    "scalar_intensity",   "intensities", "i",        "reflectance",
    "reflectivity", "scalar_reflectance", "remission",   "amplitude"};

template <class T>
T load(const char* data, bool big_endian) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), data, sizeof(T));
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

/// Calls visitor(T{}) for the C++ type of `type`.
template <class Visitor>
auto visit_type(ScalarType type, const Visitor& visitor) {
  switch (type) {
    case ScalarType::i8:
      return visitor(std::int8_t{});
    case ScalarType::u8:
      return visitor(std::uint8_t{});
    case ScalarType::i16:
      return visitor(std::int16_t{});
    case ScalarType::u16:
      return visitor(std::uint16_t{});
    case ScalarType::i32:
      return visitor(std::int32_t{});
    case ScalarType::u32:
      return visitor(std::uint32_t{});
    case ScalarType::i64:
      return visitor(std::int64_t{});
    case ScalarType::u64:
      return visitor(std::uint64_t{});
    case ScalarType::f32:
      return visitor(float{});
    case ScalarType::f64:
      break;
  }
  return visitor(double{});
}

/// Rows [begin, end) of a column to out[0], out[out_stride], ...
void copy_rows(const ScalarColumn& column, std::size_t begin, std::size_t end, float* out, std::size_t out_stride) {
  visit_type(column.type, [&](auto zero) {
    const char* data = column.data + begin * column.stride;
    for (std::size_t i = begin; i < end; ++i, data += column.stride, out += out_stride) {
      *out = static_cast<float>(load<decltype(zero)>(data, column.big_endian));
    }
  });
}

std::string lower(std::string text) {
  for (char& c : text) c = (c >= 'A' && c <= 'Z') ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

}  // namespace

std::size_t size_of(ScalarType type) {
  return visit_type(type, [](auto zero) { return sizeof(zero); });
}

double load_scalar(const char* data, ScalarType type, bool big_endian) {
  return visit_type(type, [&](auto zero) { return static_cast<double>(load<decltype(zero)>(data, big_endian)); });
}

CloudFields choose_fields(const std::vector<std::string>& names, const std::string& file) {
  CloudFields fields;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const auto found = std::find(names.begin(), names.end(), name);
    const std::string problem = found == names.end()                               ? "has no field " + name
                                : std::count(names.begin(), names.end(), name) > 1 ? "has the field " + name + " twice"
                                                                                   : "";
    if (!problem.empty()) {
      throw InputError(printable(file) + ": " + problem + " (its fields: " + in_quotes(joined(names)) +
                       "); export the cloud with one each of x, y and z");
    }
    fields.xyz[axis] = static_cast<std::size_t>(found - names.begin());
  }
  for (const std::string_view wanted : kIntensityNames) {
    const auto found =
        std::find_if(names.begin(), names.end(), [&](const auto& name) { return lower(name) == wanted; });
    if (found == names.end()) continue;
    fields.intensity = static_cast<std::size_t>(found - names.begin());
    break;
  }
  return fields;
}

PointCloud gather_columns(std::size_t count, const std::array<ScalarColumn, 3>& xyz, const ScalarColumn* intensity) {
  constexpr std::size_t kBlock = 4096;  // Small enough that the rows of a block stay in the cache for every column.
  PointCloud cloud;
  cloud.points.resize(count);
  if (intensity != nullptr) cloud.intensity.resize(count);
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const std::size_t end = std::min(count, begin + kBlock);
    for (std::size_t axis = 0; axis < 3; ++axis) copy_rows(xyz[axis], begin, end, &cloud.points[begin][axis], 3);
    if (intensity != nullptr) copy_rows(*intensity, begin, end, &cloud.intensity[begin], 1);
  }
  return cloud;
}

}  // namespace scanway
