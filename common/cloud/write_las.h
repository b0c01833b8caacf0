#pragma once

#include <string>

#include "common/cloud/point_cloud.h"

namespace scanway {

/// Writes a cloud as LAS 1.2, point format 0 (ASPRS, "LAS Specification Version 1.2"): coordinates in steps of 0.1 mm,
/// intensity rounded to 16 bits; normals are left out, for LAS has no field for them. Whole or not at all. Throws
/// InputError when the file cannot be written, and for a point further than 200 km from the origin, which the format
/// does not reach in these steps.
void write_las(const std::string& path, const PointCloud& cloud);

}  // namespace scanway
