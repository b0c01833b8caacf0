#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace scanway::bench {

/// An airborne sample whose ground points people have chosen by hand. Metres, z up, from the first point: as float32
/// UTM coordinates, which are half a metre apart in y, came.
struct Sample {
  std::string name;
  std::vector<Eigen::Vector3d> points;
  std::vector<bool> ground;  ///< One a point: the reference.

  /// Of points, metres: the edge of the square that one point has to itself.
  double spacing_m() const;
};

/// FOLDER/NAME-utm.pcd, and NAME-utm-ground.pcd with those of its points that are ground. Throws InputError.
Sample read_sample(const std::string& folder, const std::string& name);

/// Sithole and Vosselman's errors, percent.
struct Errors {
  double type_1 = 0.0;  ///< Of the ground points: called object.
  double type_2 = 0.0;  ///< Of the object points: called ground.
  double total = 0.0;   ///< Of all points: called wrongly.
};

Errors errors_of(const Sample& sample, const std::vector<bool>& called_ground);

}  // namespace scanway::bench
