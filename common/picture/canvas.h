#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "common/picture/raster.h"

namespace scanway {

/// A raster of the map on white paper: marks over it in metres, and below it a scale bar and a legend.
class Canvas {
 public:
  explicit Canvas(const Raster& raster);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// A line with a thin white seam, so that it stands out on any ground.
  void polyline(const std::vector<Eigen::Vector2d>& points_m, Colour colour);
  void start_mark(const Eigen::Vector2d& at_m);
  void goal_mark(const Eigen::Vector2d& at_m);
  /// A line of text in the middle of the map.
  void note(const std::string& text);

  // The legend's entries, from left to right.
  void legend_field(Colour colour, const std::string& text);
  void legend_line(Colour colour, const std::string& text);
  void legend_heights(double lowest_m, double highest_m);
  void legend_marks();

  /// The picture as the bytes of a PNG file.
  std::string png();

 private:
  struct Paper;
  std::unique_ptr<Paper> paper_;
};

}  // namespace scanway
