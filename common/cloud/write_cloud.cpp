#include "common/cloud/write_cloud.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace scanway {
namespace {

static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));

struct Column {
  const float* values;  ///< Of the first point.
  std::size_t stride;   ///< Floats from one point to the next.
};

constexpr float kZero = 0.0f;

void add_vectors(const std::vector<Eigen::Vector3f>& vectors, std::vector<Column>& columns) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    columns.push_back(vectors.empty() ? Column{&kZero, 0} : Column{vectors.front().data() + axis, 3});
  }
}

std::vector<Column> columns_of(const PointCloud& cloud, const CloudShape& shape) {
  std::vector<Column> columns;
  add_vectors(cloud.points, columns);
  if (shape.with_intensity) {
    columns.push_back(cloud.intensity.empty() ? Column{&kZero, 0} : Column{cloud.intensity.data(), 1});
  }
  if (shape.with_normals) add_vectors(cloud.normals, columns);
  return columns;
}

using Names = std::vector<std::string>;

Names names_of(const CloudShape& shape, const Names& normal) {
  Names names = {"x", "y", "z"};
  if (shape.with_intensity) names.push_back("intensity");
  if (shape.with_normals) names.insert(names.end(), normal.begin(), normal.end());
  return names;
}

std::string pcd_header(const CloudShape& shape) {
  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  for (const std::string& name : names_of(shape, {"normal_x", "normal_y", "normal_z"})) {
    fields += " " + name;
    sizes += " 4";
    types += " F";
    counts += " 1";
  }
  const std::string number = std::to_string(shape.points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + fields + "\n" + sizes + "\n" + types + "\n" +
         counts + "\nWIDTH " + number + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number + "\nDATA binary\n";
}

std::string ply_header(const CloudShape& shape) {
  std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(shape.points) + "\n";
  for (const std::string& name : names_of(shape, {"nx", "ny", "nz"})) header += "property float " + name + "\n";
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

void write(const std::string& path, CloudWriter::Format format, const PointCloud& cloud) {
  CloudWriter writer(path, format, {cloud.size(), !cloud.intensity.empty(), !cloud.normals.empty()});
  writer.write(cloud);
  writer.commit();
}

}  // namespace

void write_pcd(const std::string& path, const PointCloud& cloud) { write(path, CloudWriter::Format::pcd, cloud); }

void write_ply(const std::string& path, const PointCloud& cloud) { write(path, CloudWriter::Format::ply, cloud); }

CloudWriter::CloudWriter(const std::string& path, Format format, const CloudShape& shape) : file_(path), shape_(shape) {
  file_.write(format == Format::pcd ? pcd_header(shape) : ply_header(shape));
}

void CloudWriter::write(const PointCloud& part) {
  write_rows(file_, columns_of(part, shape_), part.size());
  written_ += part.size();
}

void CloudWriter::commit() {
  if (written_ != shape_.points) throw std::logic_error("CloudWriter: not as many points as its header says");
  file_.commit();
}

}  // namespace scanway
