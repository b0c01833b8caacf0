#pragma once

#include <string>
#include <vector>

#include "common/cloud/point_cloud.h"
#include "common/geometry/pose.h"

namespace scanway::bench {

/// What a way to register came to, and at what price.
struct PeerAnswer {
  std::string method;
  Pose T_target_source = Pose::Identity();
  double cpu_s = 0.0;  ///< Of everything from the clouds to the pose.
};

/// The same thinning for all: what features are computed on, and what the fine step works on.
constexpr float kCoarseVoxel = 0.3f, kFineVoxel = 0.1f;
constexpr float kNormalRadius = 0.9f, kFeatureRadius = 1.5f;
constexpr float kCorrespondence = 0.75f;  ///< 2.5 voxels, as PCL's and Open3D's own examples take it.
constexpr float kFineCorrespondence = 0.5f;

}  // namespace scanway::bench
