#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace scanway {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Colour&) const = default;
};

/// From `a` at share 0 to `b` at share 1.
Colour mix(Colour a, Colour b, double share);

/// Violet at 0 through blue and green to yellow at 1: equal steps look equal, in print and to the colour-blind
/// too.
Colour height_colour(double share);

/// Pixels over a rectangle of the map, row by row from the top (the highest y).
struct Raster {
  int width = 0;
  int height = 0;
  double metres_per_pixel = 0.01;
  Eigen::Vector2d corner_m = Eigen::Vector2d::Zero();  ///< Of the lower left pixel, in `map`.
  std::vector<Colour> pixels;

  Raster(int width, int height, double metres_per_pixel, const Eigen::Vector2d& corner_m, Colour background);
  /// x from the left, y from the top.
  Colour& at(int x, int y) { return pixels[index(x, y)]; }
  Colour at(int x, int y) const { return pixels[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// Every pixel as a square of `side` x `side` pixels.
Raster enlarged(const Raster& raster, int side);

/// The long side of a picture's map, in pixels.
constexpr int kLongSide = 1500;

}  // namespace scanway
