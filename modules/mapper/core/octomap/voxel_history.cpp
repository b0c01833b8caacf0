#include "modules/mapper/core/octomap/voxel_history.h"

#include <algorithm>

namespace scanway {

void VoxelHistory::put(SweepNumber sweep, VoxelBricks& bricks) {
  BrickNumbers numbers = bricks.numbers();
  std::vector<std::uint8_t> bytes;
  for (const VoxelBricks::BrickNumber number : numbers) pack(bricks.at(number), bytes);
  views_.emplace(sweep, View{std::move(numbers), StoredBytes(store_, std::move(bytes))});
}

BrickNumbers VoxelHistory::forget(SweepNumber sweep) {
  auto view = views_.extract(sweep);
  return view.empty() ? BrickNumbers() : std::move(view.mapped().numbers);
}

std::vector<SweepNumber> VoxelHistory::sweeps() const {
  std::vector<SweepNumber> sweeps;
  for (const auto& [sweep, view] : views_) sweeps.push_back(sweep);
  return sweeps;
}

VoxelHistory::Page VoxelHistory::read(SweepNumber sweep, const BrickNumbers& numbers) const {
  const View& view = views_.at(sweep);
  Page page;
  if (numbers.empty() || view.numbers.empty() || numbers.back() < view.numbers.front()) return page;
  page.bytes_ = view.bricks.fetch();
  std::size_t begin = 0;
  auto wanted = numbers.begin();
  for (const VoxelBricks::BrickNumber number : view.numbers) {
    wanted = std::lower_bound(wanted, numbers.end(), number);
    if (wanted == numbers.end()) break;
    if (*wanted == number) page.bricks_.push_back({static_cast<std::size_t>(wanted - numbers.begin()), begin});
    begin += packed_size(&page.bytes_[begin]);
  }
  return page;
}

}  // namespace scanway
