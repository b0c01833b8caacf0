#include "modules/mapper/core/registration/neighbourhoods.h"

#include <utility>

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
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
  std::size_t cell_end = begin;
  const float limit = radius_m * radius_m;
  for (std::size_t i = begin; i < end; ++i) {
    if (i >= cell_end) cell_end = grid.runs_about_cell(static_cast<std::uint32_t>(i), radius_m, runs);
    const std::size_t before = part.index.size();
    for (const auto& [first, last] : runs) {
      for (std::uint32_t j = first; j < last; ++j) {
        const float d2 = (grid.points()[j] - grid.points()[i]).squaredNorm();
        if (d2 > limit || j == i) continue;
        part.index.push_back(j);
        part.squared_distance.push_back(d2);
      }
    }
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
  std::size_t total = 0;
  for (const Part& part : parts) total += part.index.size();
  all.begin.reserve(grid.size() + 1);
  all.index.reserve(total);
  all.squared_distance.reserve(total);
  for (const Part& part : parts) {
    for (const std::uint32_t count : part.count) all.begin.push_back(all.begin.back() + count);
    all.index.insert(all.index.end(), part.index.begin(), part.index.end());
    all.squared_distance.insert(all.squared_distance.end(), part.squared_distance.begin(), part.squared_distance.end());
  }
  return all;
}

}  // namespace scanway::registration
