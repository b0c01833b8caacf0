#pragma once

#include <optional>
#include <span>

namespace scanway {

struct PlanePoint {
  double x = 0.0, y = 0.0;
};

struct StraightLine {
  PlanePoint at;
  double slope = 0.0;

  double y(double x) const { return at.y + (x - at.x) * slope; }
  double x(double y) const { return at.x + (y - at.y) / slope; }
};

/// Of the lines that no point lies below, the one to which the sum of the points' heights is least: for times of which
/// some are late and none is early, the times without delay. It is the edge of the lower convex hull over the points'
/// mean x (S. Moon, P. Skelly, D. Towsley, Estimation and Removal of Clock Skew from Network Delay Measurements,
/// INFOCOM 1999). `points` by rising x; nothing without two different ones.
std::optional<StraightLine> support_line(std::span<const PlanePoint> points);

}  // namespace scanway
