#include "modules/mapper/core/cloud/voxel_sums.h"

#include <algorithm>

#include "modules/mapper/core/cloud/radix_sort.h"

namespace scanway {

void add_up(std::vector<VoxelSum>& sums) {
  const auto by_key = [](const VoxelSum& a, const VoxelSum& b) { return a.key < b.key; };
  if (sums.empty()) return;
  if (!std::is_sorted(sums.begin(), sums.end(), by_key)) radix_sort_by_key(sums);
  std::size_t last = 0;
  for (std::size_t i = 1; i < sums.size(); ++i) {
    if (sums[i].key != sums[last].key) {
      sums[++last] = sums[i];
      continue;
    }
    VoxelSum& voxel = sums[last];
    voxel.count += sums[i].count;
    voxel.with_intensity += sums[i].with_intensity;
    for (std::size_t k = 0; k < 3; ++k) voxel.offset_sum[k] += sums[i].offset_sum[k];
    voxel.intensity_sum += sums[i].intensity_sum;
    for (std::size_t k = 0; k < 3; ++k) voxel.normal_sum[k] += sums[i].normal_sum[k];
  }
  sums.resize(last + 1);
}

}  // namespace scanway
