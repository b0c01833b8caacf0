#include "common/picture/raster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scanway {
namespace {

std::uint8_t mix(std::uint8_t a, std::uint8_t b, double share) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * share));
}

}  // namespace

Colour mix(Colour a, Colour b, double share) {
  share = std::clamp(share, 0.0, 1.0);
  return {mix(a.red, b.red, share), mix(a.green, b.green, share), mix(a.blue, b.blue, share)};
}

Colour height_colour(double share) {
  // Stations along matplotlib's viridis (CC0) at equal distances, without its darkest part, which sinks into the
  // ground.
  constexpr std::array<Colour, 9> kStations = {{{72, 40, 120},
                                                {64, 70, 136},
                                                {52, 97, 141},
                                                {42, 121, 142},
                                                {33, 145, 140},
                                                {39, 173, 129},
                                                {92, 200, 99},
                                                {170, 220, 50},
                                                {253, 231, 37}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kStations.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kStations.size() - 2);
  return mix(kStations[below], kStations[below + 1], at - static_cast<double>(below));
}

Raster::Raster(int width_px, int height_px, double scale, const Eigen::Vector2d& corner, Colour background)
    : width(width_px),
      height(height_px),
      metres_per_pixel(scale),
      corner_m(corner),
      pixels(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), background) {}

Raster enlarged(const Raster& raster, int side) {
  Raster large(raster.width * side, raster.height * side, raster.metres_per_pixel / side, raster.corner_m, {});
  for (int y = 0; y < large.height; ++y) {
    for (int x = 0; x < large.width; ++x) large.at(x, y) = raster.at(x / side, y / side);
  }
  return large;
}

}  // namespace scanway
