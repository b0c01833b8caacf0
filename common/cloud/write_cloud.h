#pragma once

#include <cstddef>
#include <string>

#include "common/cloud/point_cloud.h"
#include "common/files/atomic_file.h"

namespace scanway {

/// Write a cloud as float32 x y z, then intensity and the normal (PCD: normal_x ..., PLY: nx ...) where the cloud has
/// them: whole or not at all (atomic_file.h).
/// PCD 0.7 binary; PLY 1.0 binary little endian. Throw InputError when the file cannot be written.
void write_pcd(const std::string& path, const PointCloud& cloud);
void write_ply(const std::string& path, const PointCloud& cloud);

/// What a cloud's file says of it before the first point.
struct CloudShape {
  std::size_t points = 0;
  bool with_intensity = false, with_normals = false;
};

/// The same file part by part, for clouds that are not in the memory as a whole.
class CloudWriter {
 public:
  enum class Format { pcd, ply };

  CloudWriter(const std::string& path, Format format, const CloudShape& shape);

  /// The next points; of what the shape has and they do not, they get zeros.
  void write(const PointCloud& part);
  /// Throws std::logic_error unless as many points came as the shape says.
  void commit();

 private:
  AtomicFile file_;
  CloudShape shape_;
  std::size_t written_ = 0;
};

}  // namespace scanway
