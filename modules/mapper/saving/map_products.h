#pragma once

#include <map>
#include <string>

#include "common/cloud/point_cloud.h"
#include "common/files/product_folder.h"
#include "modules/mapper/node/mapper_node.h"

namespace scanway {

/// Writes everything that a map is good for: map.pcd, map.ply, map.bt, map.ot, costmap.pgm with costmap.yaml,
/// trajectory.tum, and the pictures map.png, costmap.png. Returns the digests of `map`, `octomap` and `costmap`, in
/// hexadecimal. Throws InputError when a file cannot be written.
std::map<std::string, std::string> write_map_products(const MapperNode& mapper, const ProductFolder& folder);

/// As 16 hexadecimal digits.
std::string digest_text(std::string_view bytes);

}  // namespace scanway
