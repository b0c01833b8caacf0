#include "modules/mapper/core/costmap/return_spots.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scanway {
namespace {

constexpr std::int32_t kSide = CostTile::kSide;

/// A tile and those around it, as far as the sweep has any.
class TilesAround {
 public:
  TilesAround(SweepEvidence& evidence, Cell middle) {
    for (int i = 0; i < 9; ++i) {
      const auto found = evidence.find({middle.x + i % 3 - 1, middle.y + i / 3 - 1});
      tiles_[static_cast<std::size_t>(i)] = found == evidence.end() ? nullptr : &found->second;
    }
  }

  /// (x, y): from the middle tile's low corner, at most a tile outside of it.
  void doubt(std::int32_t x, std::int32_t y) {
    const std::int32_t column = (x + kSide) / kSide, row = (y + kSide) / kSide;
    EvidenceTile* tile = tiles_[static_cast<std::size_t>(3 * row + column)];
    if (tile == nullptr) return;
    const auto cell = static_cast<std::size_t>(y + kSide - row * kSide) * kSide +
                      static_cast<std::size_t>(x + kSide - column * kSide);
    std::uint8_t& beams = tile->beams[cell];
    const bool seen_free = beams == EvidenceTile::kEmpty || beams == EvidenceTile::kSparse;
    if (seen_free && tile->returns[cell] == 0) beams = EvidenceTile::kUnsure;
  }

 private:
  std::array<EvidenceTile*, 9> tiles_{};
};

void doubt_around(TilesAround& tiles, std::int32_t x, std::int32_t y, double radius) {
  const int reach = std::min(static_cast<int>(radius), kSide);
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      if (dx * dx + dy * dy <= radius * radius) tiles.doubt(x + dx, y + dy);
    }
  }
}

}  // namespace

void doubt_spots(SweepEvidence& evidence, const Eigen::Vector3d& sensor, const SweepViewConfig& config,
                 double resolution_m) {
  for (const auto& [index, tile] : evidence) {
    TilesAround tiles(evidence, index);
    for (std::int32_t cell = 0; cell < kSide * kSide; ++cell) {
      if (tile.returns[static_cast<std::size_t>(cell)] == 0) continue;
      const std::int32_t x = cell % kSide, y = cell / kSide;
      const double dx = (index.x * kSide + x + 0.5) * resolution_m - sensor.x();
      const double dy = (index.y * kSide + y + 0.5) * resolution_m - sensor.y();
      const double radius = 0.5 * config.divergence * std::sqrt(dx * dx + dy * dy);
      doubt_around(tiles, x, y, radius / resolution_m);
    }
  }
}

}  // namespace scanway
