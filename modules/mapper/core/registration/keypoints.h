#pragma once

#include "modules/mapper/core/registration/fpfh.h"

namespace scanway::registration {

/// The distinctive points of a scan: what matching works on.
struct Keypoints {
  Points point;
  Points normal;
  std::vector<Fpfh> descriptor;
  std::size_t size() const { return point.size(); }
};

/// At most `count` points whose histograms lie farthest from the scan's mean (persistent features, Rusu 2009), nearest
/// rings around the sensor and flat ground left out that way.
Keypoints choose_keypoints(const Points& points, const Normals& normals, const std::vector<Fpfh>& features,
                           std::size_t count);

}  // namespace scanway::registration
