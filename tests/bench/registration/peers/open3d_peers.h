#pragma once

#include "tests/bench/registration/peers/peer.h"

namespace scanway::bench {

/// Voxel grid, normals, FPFH and Open3D's fast global registration, or its RANSAC over feature matches, as in its own
/// examples; on one thread.
PeerAnswer open3d_fgr(const PointCloud& source, const PointCloud& target);
PeerAnswer open3d_ransac(const PointCloud& source, const PointCloud& target);
/// Voxel grid, normals of the target and point-to-plane ICP from `start`.
PeerAnswer open3d_icp_planes(const PointCloud& source, const PointCloud& target, const Pose& start);

}  // namespace scanway::bench
