#include "modules/mapper/core/registration/keypoints.h"

#include <algorithm>
#include <utility>

namespace scanway::registration {
namespace {

Fpfh mean_of(const std::vector<Fpfh>& features) {
  std::array<double, kFpfhBins> sum{};
  for (const Fpfh& feature : features) {
    for (std::size_t b = 0; b < kFpfhBins; ++b) sum[b] += feature[b];
  }
  Fpfh mean{};
  for (std::size_t b = 0; b < kFpfhBins; ++b) {
    mean[b] = static_cast<float>(sum[b] / static_cast<double>(std::max<std::size_t>(1, features.size())));
  }
  return mean;
}

float squared_distance(const Fpfh& a, const Fpfh& b) {
  float sum = 0.0f;
  for (std::size_t k = 0; k < kFpfhBins; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

}  // namespace

Keypoints choose_keypoints(const Points& points, const Normals& normals, const std::vector<Fpfh>& features,
                           std::size_t count) {
  const Fpfh mean = mean_of(features);
  std::vector<std::pair<float, std::uint32_t>> rank;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const bool described = std::any_of(features[i].begin(), features[i].end(), [](float v) { return v > 0.0f; });
    if (described) rank.emplace_back(-squared_distance(features[i], mean), i);
  }
  std::sort(rank.begin(), rank.end());
  rank.resize(std::min(rank.size(), count));
  Keypoints keypoints;
  for (const auto& [score, i] : rank) {
    keypoints.point.push_back(points[i]);
    keypoints.normal.push_back(normals.normal[i]);
    keypoints.descriptor.push_back(features[i]);
  }
  return keypoints;
}

}  // namespace scanway::registration
