#pragma once

#include "common/random/random.h"
#include "modules/mapper/core/registration/points.h"

namespace scanway::registration {

inline Eigen::Vector3f random_point(Random& random, float half_edge) {
  const auto coordinate = [&] { return static_cast<float>((2.0 * random.uniform() - 1.0) * half_edge); };
  const float x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

inline Points random_points(Random& random, std::size_t count, float half_edge) {
  Points points(count);
  for (Eigen::Vector3f& p : points) p = random_point(random, half_edge);
  return points;
}

/// A room with a pillar and a box, as points `spacing` apart: surfaces of many directions, known normals.
inline Points room(float spacing) {
  Points points;
  const auto patch = [&](const Eigen::Vector3f& corner, const Eigen::Vector3f& u, const Eigen::Vector3f& v) {
    const auto across = static_cast<int>(u.norm() / spacing), along = static_cast<int>(v.norm() / spacing);
    for (int i = 0; i < across; ++i) {
      for (int j = 0; j < along; ++j) {
        points.push_back(corner + u * static_cast<float>(i) / static_cast<float>(across) +
                         v * static_cast<float>(j) / static_cast<float>(along));
      }
    }
  };
  const auto box = [&](const Eigen::Vector3f& low, const Eigen::Vector3f& size) {
    patch(low, {size.x(), 0, 0}, {0, 0, size.z()});
    patch(low, {0, size.y(), 0}, {0, 0, size.z()});
    patch(low + Eigen::Vector3f(0, size.y(), 0), {size.x(), 0, 0}, {0, 0, size.z()});
    patch(low + Eigen::Vector3f(size.x(), 0, 0), {0, size.y(), 0}, {0, 0, size.z()});
    patch(low + Eigen::Vector3f(0, 0, size.z()), {size.x(), 0, 0}, {0, size.y(), 0});
  };
  patch({-6, -4, -1.2f}, {12, 0, 0}, {0, 8, 0});
  box({-6, -4, -1.2f}, {12, 8, 3});
  box({2, 1, -1.2f}, {1, 1.5f, 1});
  box({-4, -2.5f, -1.2f}, {0.5f, 0.5f, 2.5f});
  box({-1.5f, 2.2f, -1.2f}, {2, 0.8f, 1.8f});
  return points;
}

}  // namespace scanway::registration
