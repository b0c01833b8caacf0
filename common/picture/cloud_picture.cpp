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
    if (point.allFinite() && point.z() <= cut_height_m) points.push_back(point);
  }
  return points;
}

Raster raster_over(const std::vector<Eigen::Vector3f>& points) {
  constexpr double kStray = 0.002, kBorder_m = 0.5;
  const auto [x_low, x_high] = extent(points, 0, kStray);
  const auto [y_low, y_high] = extent(points, 1, kStray);
  const double width_m = x_high - x_low + 2 * kBorder_m, height_m = y_high - y_low + 2 * kBorder_m;
  const double scale = std::max({width_m, height_m, 5.0}) / kLongSide;
  return Raster(std::max(1, static_cast<int>(width_m / scale)), std::max(1, static_cast<int>(height_m / scale)), scale,
                {x_low - kBorder_m, y_low - kBorder_m}, kGround);
}

/// What lies on a pixel.
struct Pile {
  std::uint32_t points = 0;
  float highest = -1e30f;
};

std::vector<Pile> piles_of(const std::vector<Eigen::Vector3f>& points, const Raster& raster) {
  std::vector<Pile> piles(raster.pixels.size());
  for (const Eigen::Vector3f& point : points) {
    const double x = std::floor((point.x() - raster.corner_m.x()) / raster.metres_per_pixel);
    const double y = raster.height - 1 - std::floor((point.y() - raster.corner_m.y()) / raster.metres_per_pixel);
    if (x < 0 || y < 0 || x >= raster.width || y >= raster.height) continue;
    Pile& pile =
        piles[static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) + static_cast<std::size_t>(x)];
    ++pile.points;
    pile.highest = std::max(pile.highest, point.z());
  }
  return piles;
}

/// The count that only one pixel in fifty with points exceeds.
double dense_count(const std::vector<Pile>& piles) {
  std::vector<float> counts;
  for (const Pile& pile : piles) {
    if (pile.points > 0) counts.push_back(static_cast<float>(pile.points));
  }
  return std::max(2.0f, quantile(counts, 0.98));
}

void colour(Raster& raster, const std::vector<Pile>& piles, double lowest, double highest) {
  const double full = repeatable::log(1.0 + dense_count(piles));
  for (std::size_t i = 0; i < piles.size(); ++i) {
    if (piles[i].points == 0) continue;
    const double density = std::min(1.0, repeatable::log(1.0 + piles[i].points) / full);
    const Colour pure = height_colour((piles[i].highest - lowest) / (highest - lowest));
    raster.pixels[i] = mix(kGround, pure, 0.35 + 0.65 * density);
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
  Raster raster = raster_over(points);
  const double lowest = extent(points, 2, 0.01)[0], highest = std::max(cut_height_m, lowest + 0.1);
  colour(raster, piles_of(points, raster), lowest, highest);
  Canvas canvas(raster);
  canvas.legend_heights(lowest, highest);
  write_file(path, canvas.png());
}

}  // namespace scanway
