#pragma once

#include <map>
#include <string>

#include "common/files/product_folder.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/planner/node/planner_node.h"

namespace scanway {

/// Writes everything that a map and a plan are good for: map.pcd, map.ply, map.bt, map.ot, costmap.pgm with
/// costmap.yaml, trajectory.tum, path.csv, and the pictures map.png, costmap.png, path.png. Returns the digests of
/// `map`, `octomap`, `costmap` and `path`, in hexadecimal. Throws InputError when a file cannot be written.
std::map<std::string, std::string> write_products(const MapperNode& mapper, const PlannerNode& planner,
                                                  const ProductFolder& folder);

}  // namespace scanway
