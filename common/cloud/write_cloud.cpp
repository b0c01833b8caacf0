#include "common/cloud/write_cloud.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "common/files/atomic_file.h"

namespace scanway {
namespace {

static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));

bool has_intensity(const PointCloud& cloud) { return !cloud.intensity.empty(); }

std::string pcd_header(const PointCloud& cloud) {
  const std::string count = std::to_string(cloud.size());
  const std::string fields = has_intensity(cloud)
                                 ? "FIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
                                 : "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + fields + "WIDTH " + count +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA binary\n";
}

std::string ply_header(const PointCloud& cloud) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(cloud.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\n" +
         (has_intensity(cloud) ? "property float intensity\n" : "") + "end_header\n";
}

/// Rows of x y z [intensity], a block of rows at a time.
void write_rows(AtomicFile& file, const PointCloud& cloud) {
  constexpr std::size_t kBlock = 65536;
  const std::size_t columns = has_intensity(cloud) ? 4 : 3;
  std::string block;
  for (std::size_t begin = 0; begin < cloud.size(); begin += kBlock) {
    const std::size_t end = std::min(cloud.size(), begin + kBlock);
    block.resize((end - begin) * columns * sizeof(float));
    char* row = block.data();
    for (std::size_t i = begin; i < end; ++i, row += columns * sizeof(float)) {
      std::memcpy(row, cloud.points[i].data(), 3 * sizeof(float));
      if (columns == 4) std::memcpy(row + 3 * sizeof(float), &cloud.intensity[i], sizeof(float));
    }
    file.write(block);
  }
}

void write(const std::string& path, const std::string& header, const PointCloud& cloud) {
  AtomicFile file(path);
  file.write(header);
  write_rows(file, cloud);
  file.commit();
}

}  // namespace

void write_pcd(const std::string& path, const PointCloud& cloud) { write(path, pcd_header(cloud), cloud); }
void write_ply(const std::string& path, const PointCloud& cloud) { write(path, ply_header(cloud), cloud); }

}  // namespace scanway
