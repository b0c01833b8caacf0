#pragma once

#include "tests/bench/registration/peers/peer.h"

namespace scanway::bench {

/// Voxel grid, normals, FPFH and PCL's SampleConsensusInitialAlignment with its own number of iterations (1,000).
PeerAnswer pcl_sac_ia(const PointCloud& source, const PointCloud& target);
/// The same with SampleConsensusPrerejective as in PCL's tutorial (50,000 iterations).
PeerAnswer pcl_prerejective(const PointCloud& source, const PointCloud& target);

/// Voxel grid and IterativeClosestPoint, or (with normals of both) IterativeClosestPointWithNormals, from `start`.
PeerAnswer pcl_icp_points(const PointCloud& source, const PointCloud& target, const Pose& start);
PeerAnswer pcl_icp_planes(const PointCloud& source, const PointCloud& target, const Pose& start);

}  // namespace scanway::bench
