#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>

namespace scanway {

/// The columns within `reach` columns of one, itself left out, nearest first.
inline std::vector<Eigen::Vector2i> offsets_within(int reach) {
  std::vector<Eigen::Vector2i> offsets;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      if ((x != 0 || y != 0) && x * x + y * y <= reach * reach) offsets.emplace_back(x, y);
    }
  }
  std::stable_sort(offsets.begin(), offsets.end(),
                   [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); });
  return offsets;
}

}  // namespace scanway
