#include "common/cloud/write_las.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

#include "common/files/atomic_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {
namespace {

constexpr double kStep = 1e-4;     // metres
constexpr double kFarthest = 2e5;  // metres
constexpr std::size_t kHeaderBytes = 227, kPointBytes = 20;
constexpr char kOnlyReturn = 1 | 1 << 3;  // Return 1 of 1.

struct Extent {
  std::array<double, 3> low{}, high{};
};

std::int32_t steps(float coordinate) {
  return static_cast<std::int32_t>(std::lround(static_cast<double>(coordinate) / kStep));
}

template <class T>
void append(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof value);
  bytes.append(raw.data(), raw.size());
}

void append_text(std::string& bytes, std::string_view text, std::size_t width) {
  bytes.append(text);
  bytes.append(width - text.size(), '\0');
}

/// Of the points as the file has them.
Extent extent_of(const PointCloud& cloud) {
  Extent extent;
  for (int axis = 0; axis < 3; ++axis) {
    const auto by_axis = [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; };
    const auto [low, high] = std::minmax_element(cloud.points.begin(), cloud.points.end(), by_axis);
    if (cloud.empty()) return extent;
    extent.low[static_cast<std::size_t>(axis)] = steps((*low)[axis]) * kStep;
    extent.high[static_cast<std::size_t>(axis)] = steps((*high)[axis]) * kStep;
  }
  return extent;
}

std::string las_header(const PointCloud& cloud) {
  const auto count = static_cast<std::uint32_t>(cloud.size());
  std::string bytes = "LASF";
  bytes.append(4 + 16, '\0');  // File source, global encoding, project.
  bytes += {1, 2};             // Version.
  append_text(bytes, "OTHER", 32);
  append_text(bytes, "scanway", 32);
  bytes.append(4, '\0');  // Day and year: the same map is the same file on any day.
  append<std::uint16_t>(bytes, kHeaderBytes);
  append<std::uint32_t>(bytes, kHeaderBytes);  // Where the points begin.
  append<std::uint32_t>(bytes, 0);             // Variable length records.
  bytes.push_back(0);                          // Point format.
  append<std::uint16_t>(bytes, kPointBytes);
  append(bytes, count);
  append(bytes, count);       // First returns,
  bytes.append(4 * 4, '\0');  // and no others.
  for (int axis = 0; axis < 3; ++axis) append(bytes, kStep);
  for (int axis = 0; axis < 3; ++axis) append(bytes, 0.0);  // Offset.
  const Extent extent = extent_of(cloud);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    append(bytes, extent.high[axis]);
    append(bytes, extent.low[axis]);
  }
  return bytes;
}

void append_point(std::string& bytes, const PointCloud& cloud, std::size_t i) {
  for (int axis = 0; axis < 3; ++axis) append(bytes, steps(cloud.points[i][axis]));
  const float intensity = cloud.intensity.empty() ? 0.0F : cloud.intensity[i];
  append(bytes, static_cast<std::uint16_t>(std::clamp(std::round(intensity), 0.0F, 65535.0F)));
  bytes.push_back(kOnlyReturn);
  bytes.append(5, '\0');  // Class, angle, user data, source.
}

void check_reach(const std::string& path, const PointCloud& cloud) {
  const bool reached = std::all_of(cloud.points.begin(), cloud.points.end(), [](const Eigen::Vector3f& p) {
    return p.cast<double>().cwiseAbs().maxCoeff() <= kFarthest;
  });
  if (!reached) throw InputError(printable(path) + ": LAS does not hold points further away than 200 km");
  if (cloud.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError(printable(path) + ": LAS 1.2 does not hold more than 4 billion points");
  }
}

}  // namespace

void write_las(const std::string& path, const PointCloud& cloud) {
  constexpr std::size_t kBlock = 65536;
  check_reach(path, cloud);
  AtomicFile file(path);
  file.write(las_header(cloud));
  for (std::size_t begin = 0; begin < cloud.size(); begin += kBlock) {
    std::string block;
    for (std::size_t i = begin; i < std::min(cloud.size(), begin + kBlock); ++i) append_point(block, cloud, i);
    file.write(block);
  }
  file.commit();
}

}  // namespace scanway
