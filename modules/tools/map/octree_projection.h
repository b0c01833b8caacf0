#pragma once

#include <string>

#include "common/grid/cost_map.h"
#include "common/octree/octree_file.h"

namespace scanway::tools {

/// What a robot on level ground meets.
struct BodyBand {
  double ground_z_m = 0.0;
  double climbable_step_m = 0.02;
  double height_m = 1.5;
};

/// An OctoMap as a cost map's states, a cell a voxel's column, for level ground. The voxels that hold the ground are
/// those that begin at or below the climbable step; nothing lower than the next voxel above can be told from them.
///   occupied  a voxel above these, and below the body's height, is occupied; or the ground is missing: the voxel below
///             the ground's is free (a drop-off)
///   free      not so, and the voxel above the ground's is free, or the ground's is occupied
///   unknown   else
/// Throws InputError (with `name` for the file) for a map of more than 36 million cells.
CostMap project(const OctreeFile& tree, const BodyBand& band, const std::string& name);

}  // namespace scanway::tools
