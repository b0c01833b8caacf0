#include "modules/mapper/core/registration/range_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanway::registration {
namespace {

constexpr float kMargin = 0.3f;           // metres: pose error, thinning, thickness of things
constexpr float kRelativeMargin = 0.03f;  // of the range: a pixel's width on a slanted surface

}  // namespace

std::optional<std::size_t> RangeImage::pixel_of(const Eigen::Vector3f& point) {
  int axis = 0;
  const float major = point.cwiseAbs().maxCoeff(&axis);
  if (!(major > 0.0f)) return std::nullopt;
  const int face = 2 * axis + (point[axis] < 0.0f ? 1 : 0);
  const auto pixel = [&](float v) {
    return std::clamp(static_cast<int>((v / major + 1.0f) * (0.5f * kEdge)), 0, kEdge - 1);
  };
  return static_cast<std::size_t>((face * kEdge + pixel(point[(axis + 1) % 3])) * kEdge + pixel(point[(axis + 2) % 3]));
}

RangeImage::RangeImage(const Points& points) {
  constexpr std::size_t kPixels = 6 * kEdge * kEdge;
  std::vector<float> low(kPixels, std::numeric_limits<float>::max()), high(kPixels, 0.0f);
  for (const Eigen::Vector3f& point : points) {
    const auto pixel = pixel_of(point);
    if (!pixel) continue;
    const float range = point.norm();
    low[*pixel] = std::min(low[*pixel], range);
    high[*pixel] = std::max(high[*pixel], range);
  }
  nearest_.assign(kPixels, 0.0f);
  farthest_.assign(kPixels, 0.0f);
  for (std::size_t i = 0; i < kPixels; ++i) {
    if (high[i] == 0.0f) continue;
    const int row = static_cast<int>(i) / kEdge % kEdge, column = static_cast<int>(i) % kEdge;
    nearest_[i] = low[i];
    farthest_[i] = high[i];
    for (int dr = row > 0 ? -1 : 0; dr <= (row < kEdge - 1 ? 1 : 0); ++dr) {
      for (int dc = column > 0 ? -1 : 0; dc <= (column < kEdge - 1 ? 1 : 0); ++dc) {
        const auto j = static_cast<std::size_t>(static_cast<int>(i) + dr * kEdge + dc);
        nearest_[i] = std::min(nearest_[i], low[j]);
        farthest_[i] = std::max(farthest_[i], high[j]);
      }
    }
  }
}

RangeImage::Sight RangeImage::look(const Eigen::Vector3f& point) const {
  const auto pixel = pixel_of(point);
  if (!pixel || nearest_.empty() || nearest_[*pixel] == 0.0f) return Sight::unseen;
  const float range = point.norm(), margin = kMargin + kRelativeMargin * range;
  if (range < nearest_[*pixel] - margin) return Sight::free;
  return range > farthest_[*pixel] + margin ? Sight::hidden : Sight::surface;
}

}  // namespace scanway::registration
