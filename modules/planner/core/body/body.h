#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "modules/planner/core/body/spans.h"

namespace scanway::planning {

/// The robot stands at multiples of 22.5 degrees: heading k is k * 22.5 degrees, counter-clockwise from x.
constexpr int kHeadings = 16;

/// The eight steps to a neighbouring cell: step d goes into the direction of heading 2 d.
constexpr int kSteps = 8;
constexpr std::array<std::int32_t, kSteps> kStepX = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<std::int32_t, kSteps> kStepY = {0, 1, 1, 1, 0, -1, -1, -1};
constexpr int opposite(int step) { return (step + 4) & 7; }

/// The angle of a heading, radians in (-pi, pi].
double angle_of(int heading);

/// Which cells the robot's footprint needs: standing at a heading, turning in place from one heading to the next, and
/// stepping to a neighbouring cell. All relative to the cell in whose middle the robot's centre is.
class Body {
 public:
  /// `footprint` in metres in `base`, corners in order.
  Body(const std::vector<Eigen::Vector2d>& footprint, double resolution_m);

  const Spans& standing(int heading) const { return standing_[heading & (kHeadings - 1)]; }
  /// From `heading` to `heading` + 1, and back.
  const Spans& turning(int heading) const { return turning_[heading & (kHeadings - 1)]; }
  /// From one cell to its neighbour at `step`, beyond what standing in either needs. Empty for most bodies.
  const Spans& stepping(int heading, int step) const { return stepping_[heading & (kHeadings - 1)][step]; }
  /// Moving from the cell's middle by (dx, dy) cells at the heading of that vector. For footprints that are not convex:
  /// of their convex hull.
  Spans sweeping(double dx, double dy) const;

  /// Cells; the footprint at every heading lies within the one and holds the other.
  double circumscribed() const { return circumscribed_; }
  double inscribed() const { return inscribed_; }
  /// The footprint in cells, at heading 0.
  const Polygon& footprint() const { return footprint_; }

 private:
  Polygon footprint_;
  double circumscribed_ = 0.0;
  double inscribed_ = 0.0;
  std::array<Spans, kHeadings> standing_;
  std::array<Spans, kHeadings> turning_;
  std::array<std::array<Spans, kSteps>, kHeadings> stepping_;
};

/// A polygon turned about the origin by the angle whose cosine and sine are given, then moved.
Polygon placed(const Polygon& polygon, double cosine, double sine, double x, double y);

}  // namespace scanway::planning
