#include "modules/mapper/core/registration/neighbourhoods.h"

#include <utility>

#include "common/parallel/blocks.h"

namespace scanway::registration {
namespace {

constexpr std::size_t kBlock = 256;
constexpr std::size_t kExpected = 96;  // neighbours of a point

struct Part {
  std::vector<std::uint32_t> count, index;
  std::vector<float> squared_distance;
};

/// Of `count` points from one.
__attribute__((target_clones("default", "avx2"))) void squared_distances(const float* x, const float* y, const float* z,
                                                                         std::size_t count, const float* point,
                                                                         float* __restrict d2) {
  const float px = point[0], py = point[1], pz = point[2];
  for (std::size_t k = 0; k < count; ++k) {
    const float dx = x[k] - px, dy = y[k] - py, dz = z[k] - pz;
    d2[k] = dx * dx + (dy * dy + dz * dz);
  }
}

/// The points that may be neighbours of those in one cell, by coordinate, so that distances come in vectors.
class Candidates {
 public:
  void gather(const CellGrid& grid, std::uint32_t position, float radius) {
    position_.clear(), x_.clear(), y_.clear(), z_.clear();
    end_ = grid.runs_about_cell(position, radius, runs_);
    for (const auto& [first, last] : runs_) {
      for (std::uint32_t j = first; j < last; ++j) {
        const Eigen::Vector3f& p = grid.points()[j];
        position_.push_back(j), x_.push_back(p.x()), y_.push_back(p.y()), z_.push_back(p.z());
      }
    }
    d2_.resize(position_.size());
    near_.resize(position_.size());
    near_d2_.resize(position_.size());
  }
  /// The first position after the cell.
  std::size_t end() const { return end_; }

  /// Appends those within the distance of the point, without itself.
  void append_near(const Eigen::Vector3f& point, std::uint32_t itself, float squared_limit, Part& part) {
    squared_distances(x_.data(), y_.data(), z_.data(), d2_.size(), point.data(), d2_.data());
    std::size_t count = 0;
    for (std::size_t k = 0; k < d2_.size(); ++k) {  // without a branch, for every other one is near
      near_[count] = position_[k];
      near_d2_[count] = d2_[k];
      count += static_cast<std::size_t>(d2_[k] <= squared_limit) & static_cast<std::size_t>(position_[k] != itself);
    }
    const auto end = static_cast<std::ptrdiff_t>(count);
    part.count.push_back(static_cast<std::uint32_t>(count));
    part.index.insert(part.index.end(), near_.begin(), near_.begin() + end);
    part.squared_distance.insert(part.squared_distance.end(), near_d2_.begin(), near_d2_.begin() + end);
  }

 private:
  std::size_t end_ = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs_;
  std::vector<std::uint32_t> position_, near_;
  std::vector<float> x_, y_, z_, d2_, near_d2_;
};

Part search(const CellGrid& grid, float radius_m, std::size_t begin, std::size_t end) {
  Part part;
  part.count.reserve(end - begin);
  part.index.reserve((end - begin) * kExpected);
  part.squared_distance.reserve((end - begin) * kExpected);
  Candidates candidates;
  for (std::size_t i = begin; i < end; ++i) {
    const auto position = static_cast<std::uint32_t>(i);
    if (i >= candidates.end()) candidates.gather(grid, position, radius_m);
    candidates.append_near(grid.points()[i], position, radius_m * radius_m, part);
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
