#pragma once

#include <map>
#include <string>

#include "common/files/product_folder.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/planner/node/planner_node.h"

namespace scanway {

/// What write_map_products() does, and path.csv and path.png: returns the digest of `path` too.
std::map<std::string, std::string> write_products(const MapperNode& mapper, const PlannerNode& planner,
                                                  const ProductFolder& folder);

}  // namespace scanway
