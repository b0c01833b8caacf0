#include "common/cloud/write_cloud.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

#include "common/files/atomic_file.h"

namespace scanway {
namespace {

static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));

struct Column {
  std::string name;
  const float* values;  ///< Of the first point.
  std::size_t stride;   ///< Floats from one point to the next.
};

void add_vectors(const std::array<std::string, 3>& names, const std::vector<Eigen::Vector3f>& vectors,
                 std::vector<Column>& columns) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    columns.push_back({names[axis], vectors.empty() ? nullptr : vectors.front().data() + axis, 3});
  }
}

std::vector<Column> columns_of(const PointCloud& cloud, const std::array<std::string, 3>& normal) {
  std::vector<Column> columns;
  add_vectors({"x", "y", "z"}, cloud.points, columns);
  if (!cloud.intensity.empty()) columns.push_back({"intensity", cloud.intensity.data(), 1});
  if (!cloud.normals.empty()) add_vectors(normal, cloud.normals, columns);
  return columns;
}

std::string pcd_header(const std::vector<Column>& columns, std::size_t points) {
  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  for (const Column& column : columns) {
    fields += " " + column.name;
    sizes += " 4";
    types += " F";
    counts += " 1";
  }
  const std::string number = std::to_string(points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + fields + "\n" + sizes + "\n" + types + "\n" +
         counts + "\nWIDTH " + number + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number + "\nDATA binary\n";
}

std::string ply_header(const std::vector<Column>& columns, std::size_t points) {
  std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points) + "\n";
  for (const Column& column : columns) header += "property float " + column.name + "\n";
  return header + "end_header\n";
}

/// A row a point, a block of rows at a time.
void write_rows(AtomicFile& file, const std::vector<Column>& columns, std::size_t points) {
  constexpr std::size_t kBlock = 65536;
  std::string block;
  for (std::size_t begin = 0; begin < points; begin += kBlock) {
    const std::size_t end = std::min(points, begin + kBlock);
    block.resize((end - begin) * columns.size() * sizeof(float));
    char* to = block.data();
    for (std::size_t i = begin; i < end; ++i) {
      for (const Column& column : columns) {
        std::memcpy(to, column.values + i * column.stride, sizeof(float));
        to += sizeof(float);
      }
    }
    file.write(block);
  }
}

void write(const std::string& path, const std::string& header, const std::vector<Column>& columns, std::size_t points) {
  AtomicFile file(path);
  file.write(header);
  write_rows(file, columns, points);
  file.commit();
}

}  // namespace

void write_pcd(const std::string& path, const PointCloud& cloud) {
  const std::vector<Column> columns = columns_of(cloud, {"normal_x", "normal_y", "normal_z"});
  write(path, pcd_header(columns, cloud.size()), columns, cloud.size());
}

void write_ply(const std::string& path, const PointCloud& cloud) {
  const std::vector<Column> columns = columns_of(cloud, {"nx", "ny", "nz"});
  write(path, ply_header(columns, cloud.size()), columns, cloud.size());
}

}  // namespace scanway
