#pragma once

#include <vector>

#include <Eigen/Core>

#include "common/cloud/point_cloud.h"
#include "common/grid/cost_map.h"
#include "common/robot/robot.h"
#include "modules/mapper/core/ground/ground_plane.h"

namespace scanway {

/// The paper's map: the registered cloud without its ground, seen from above.
///
/// Ground are the points from 0 to the climbable step over the plane, widened by the range's deviation on both sides
/// ([-0.01, 0.03] m for ERA-Mobi); points over the body's height are left out, too. Every other point makes its cell
/// occupied, those below the ground included. A cell without such a point is free, within the bounding rectangle of all
/// the points; nothing in it is unknown. Only points within `reach_m` of one of the `origins` (sensors, map frame)
/// count, horizontally: stray returns from far away would make the rectangle endless.
void project_as_paper(CostMap& map, const PointCloud& registered, const GroundPlane& ground, const Robot& robot,
                      const std::vector<Eigen::Vector3d>& origins, double reach_m);

}  // namespace scanway
