#include "modules/mapper/core/registration/neighbourhoods.h"

#include "common/parallel/blocks.h"

namespace scanway::registration {
namespace {

constexpr std::size_t kBlock = 512;

struct Part {
  std::vector<std::uint32_t> count, index;
  std::vector<float> squared_distance;
};

Part search(const CellGrid& grid, float radius_m, std::size_t begin, std::size_t end) {
  Part part;
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t before = part.index.size();
    grid.for_each_within(grid.points()[i], radius_m, [&](std::uint32_t j, float d2) {
      if (j == i) return;
      part.index.push_back(j);
      part.squared_distance.push_back(d2);
    });
    part.count.push_back(static_cast<std::uint32_t>(part.index.size() - before));
  }
  return part;
}

}  // namespace

Neighbourhoods find_neighbourhoods(const CellGrid& grid, float radius_m) {
  std::vector<Part> parts((grid.size() + kBlock - 1) / kBlock);
  for_blocks(grid.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t block) {
    parts[block] = search(grid, radius_m, begin, end);
  });
  Neighbourhoods all;
  all.begin.push_back(0);
  for (const Part& part : parts) {
    for (const std::uint32_t count : part.count) all.begin.push_back(all.begin.back() + count);
    all.index.insert(all.index.end(), part.index.begin(), part.index.end());
    all.squared_distance.insert(all.squared_distance.end(), part.squared_distance.begin(), part.squared_distance.end());
  }
  return all;
}

}  // namespace scanway::registration
