#pragma once

#include <optional>

#include "modules/mapper/core/registration/points.h"

namespace scanway::registration {

/// How far the sensor saw in every direction: a picture of ranges on the six faces of a cube about it, which needs no
/// trigonometry. A point of another scan well in front of what was seen there lies where beams passed: in free space.
class RangeImage {
 public:
  RangeImage() = default;
  explicit RangeImage(const Points& points);

  enum class Sight { unseen, free, surface, hidden };
  /// What this scan says of a point in its frame: in front of all that was seen thereabouts (free), at it, or behind.
  Sight look(const Eigen::Vector3f& point) const;

 private:
  static constexpr int kEdge = 72;  ///< Pixels of a face's edge: 1.6 degrees in its middle.
  static std::optional<std::size_t> pixel_of(const Eigen::Vector3f& point);

  std::vector<float> nearest_;  ///< Of a pixel and its neighbours; 0 where the pixel itself saw nothing.
  std::vector<float> farthest_;
};

}  // namespace scanway::registration
