#include <algorithm>
#include <array>
#include <cmath>

#include "common/files/atomic_file.h"
#include "common/math/repeatable.h"
#include "common/picture/canvas.h"
#include "common/picture/pictures.h"

namespace scanway {
namespace {

constexpr Colour kGround = {13, 14, 20};

/// The value that the share `share` of `values` lies below.
float quantile(std::vector<float>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// From where to where nearly all points lie along one axis. The few that strayed shall not shrink the picture.
std::array<float, 2> extent(const std::vector<Eigen::Vector3f>& points, int axis, double stray_share) {
  std::vector<float> values;
  values.reserve(points.size());
  for (const Eigen::Vector3f& point : points) values.push_back(point[axis]);
  return {quantile(values, stray_share), quantile(values, 1.0 - stray_share)};
}

std::vector<Eigen::Vector3f> below(const PointCloud& cloud, double cut_height_m) {
  std::vector<Eigen::Vector3f> points;
  points.reserve(cloud.size());
  for (const Eigen::Vector3f& point : cloud.points) {
    constexpr float kFar = 1e6f;  // metres; farther points are not measurements
    const bool near = point.allFinite() && point.cwiseAbs().maxCoeff() < kFar;
    if (near && point.z() <= cut_height_m) points.push_back(point);
  }
  return points;
}

/// Where the picture lies on the map: a grid of square spots.
struct Frame {
  Eigen::Vector2d corner_m;
  double spot_m;
  int columns, rows;
};

Frame frame_around(const std::vector<Eigen::Vector3f>& points, int pixels_a_spot) {
  constexpr double kStray = 0.004, kBorder_m = 0.5;
  const auto [x_low, x_high] = extent(points, 0, kStray);
  const auto [y_low, y_high] = extent(points, 1, kStray);
  const double width_m = x_high - x_low + 2 * kBorder_m, height_m = y_high - y_low + 2 * kBorder_m;
  const double spot_m = std::max({width_m, height_m, 5.0}) / kLongSide * pixels_a_spot;
  const auto spots = [&](double length_m) { return std::max(1, static_cast<int>(length_m / spot_m)); };
  return {{x_low - kBorder_m, y_low - kBorder_m}, spot_m, spots(width_m), spots(height_m)};
}

/// What lies on a spot.
struct Pile {
  std::uint32_t points = 0;
  float highest = -1e30f;
};

/// Row by row from the top.
std::vector<Pile> piles_of(const std::vector<Eigen::Vector3f>& points, const Frame& frame) {
  std::vector<Pile> piles(static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows));
  for (const Eigen::Vector3f& point : points) {
    const double x = std::floor((point.x() - frame.corner_m.x()) / frame.spot_m);
    const double y = frame.rows - 1 - std::floor((point.y() - frame.corner_m.y()) / frame.spot_m);
    if (x < 0 || y < 0 || x >= frame.columns || y >= frame.rows) continue;
    Pile& pile =
        piles[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.columns) + static_cast<std::size_t>(x)];
    ++pile.points;
    pile.highest = std::max(pile.highest, point.z());
  }
  return piles;
}

std::vector<float> counts_of(const std::vector<Pile>& piles) {
  std::vector<float> counts;
  for (const Pile& pile : piles) {
    if (pile.points > 0) counts.push_back(static_cast<float>(pile.points));
  }
  return counts;
}

/// A thin cloud gets larger spots, so that its surfaces do not fall apart into dots.
int pixels_a_spot_for(const std::vector<Eigen::Vector3f>& points) {
  constexpr double kPointsASpot = 3.0;
  int side = 1;
  while (side < 4) {
    const std::size_t filled = counts_of(piles_of(points, frame_around(points, side))).size();
    if (static_cast<double>(points.size()) >= kPointsASpot * static_cast<double>(filled)) break;
    ++side;
  }
  return side;
}

/// Height by colour, density by brightness: walls, where points pile up, stand out.
Raster raster_of(const std::vector<Pile>& piles, const Frame& frame, double lowest, double highest) {
  Raster raster(frame.columns, frame.rows, frame.spot_m, frame.corner_m, kGround);
  auto counts = counts_of(piles);
  const double full = repeatable::log(1.0 + std::max(2.0f, quantile(counts, 0.98)));
  for (std::size_t i = 0; i < piles.size(); ++i) {
    if (piles[i].points == 0) continue;
    const double density = std::min(1.0, repeatable::log(1.0 + piles[i].points) / full);
    const Colour pure = height_colour((piles[i].highest - lowest) / (highest - lowest));
    raster.pixels[i] = mix(kGround, pure, 0.4 + 0.6 * density);
  }
  return raster;
}

/// Fills single empty spots within surfaces: those with at least five full neighbours.
void fill_pinholes(Raster& raster) {
  const Raster before = raster;
  for (int y = 1; y + 1 < raster.height; ++y) {
    for (int x = 1; x + 1 < raster.width; ++x) {
      if (before.at(x, y) != kGround) continue;
      int full = 0, red = 0, green = 0, blue = 0;
      for (int k = 0; k < 9; ++k) {
        const Colour c = before.at(x - 1 + k % 3, y - 1 + k / 3);
        if (c == kGround) continue;
        ++full;
        red += c.red, green += c.green, blue += c.blue;
      }
      const auto mean = [&](int sum) { return static_cast<std::uint8_t>(sum / full); };
      if (full >= 5) raster.at(x, y) = {mean(red), mean(green), mean(blue)};
    }
  }
}

}  // namespace

void draw_cloud_from_above(const std::string& path, const PointCloud& cloud, double cut_height_m) {
  const std::vector<Eigen::Vector3f> points = below(cloud, cut_height_m);
  if (points.empty()) {
    Canvas canvas(Raster(800, 400, 0.01, {0, 0}, {255, 255, 255}));
    canvas.note("no points below the cut");
    return write_file(path, canvas.png());
  }
  const int pixels_a_spot = pixels_a_spot_for(points);
  const Frame frame = frame_around(points, pixels_a_spot);
  const double lowest = extent(points, 2, 0.01)[0], highest = std::max(cut_height_m, lowest + 0.1);
  Raster raster = raster_of(piles_of(points, frame), frame, lowest, highest);
  fill_pinholes(raster);
  Canvas canvas(enlarged(raster, pixels_a_spot));
  canvas.legend_heights(lowest, highest);
  write_file(path, canvas.png());
}

}  // namespace scanway
