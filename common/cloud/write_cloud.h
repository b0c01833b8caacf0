#pragma once

#include <string>

#include "common/cloud/point_cloud.h"

namespace scanway {

/// Write a cloud as float32 x y z, then intensity and the normal (PCD: normal_x ..., PLY: nx ...) where the cloud has
/// them: whole or not at all (atomic_file.h).
/// PCD 0.7 binary; PLY 1.0 binary little endian. Throw InputError when the file cannot be written.
void write_pcd(const std::string& path, const PointCloud& cloud);
void write_ply(const std::string& path, const PointCloud& cloud);

}  // namespace scanway
