#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "common/cloud/point_cloud.h"
#include "common/grid/cost_map.h"

namespace scanway {

/// PNG pictures for people, seen from above: x right, y up, with a scale bar and a legend. The long side is at most
/// about 1,600 pixels. The same input gives the same file. All throw InputError when the file cannot be written, and
/// leave what was there as it was.

/// A cloud in `map`, coloured by height; what lies above `cut_height_m` (the ceiling) is left out.
void draw_cloud_from_above(const std::string& path, const PointCloud& cloud, double cut_height_m);

/// Free white, unknown grey, occupied black, cost as a tint, lethal cells by a colour of their own.
void draw_cost_map(const std::string& path, const CostMap& map);

/// What draw_path() draws over the map: metres in `map`. A path without poses is not drawn.
struct PathPicture {
  Eigen::Vector2d start_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d goal_m = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> without_embodiment;  ///< Drawn in red.
  std::vector<Eigen::Vector2d> with_embodiment;     ///< Drawn in purple.
};

void draw_path(const std::string& path, const CostMap& map, const PathPicture& paths);

}  // namespace scanway
