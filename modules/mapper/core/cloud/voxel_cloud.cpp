#include "modules/mapper/core/cloud/voxel_cloud.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "modules/mapper/core/cloud/centroids.h"
#include "modules/mapper/core/cloud/packed_sweep.h"
#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

constexpr VoxelCloud::TileNumber kNoTile = std::numeric_limits<VoxelCloud::TileNumber>::max();  // after all others

}  // namespace

VoxelCloud::VoxelCloud(double voxel_m, std::shared_ptr<ByteStore> store)
    : voxel_m_(voxel_m), store_(std::move(store)) {}

void VoxelCloud::put(SweepNumber sweep, const MapPoints& points) {
  const std::vector<PackedTile> tiles = packed_sweep(points, voxel_m_);
  std::map<TileNumber, std::size_t> begin;
  std::size_t size = 0, voxels = 0, points_left_out = points.points.size();
  for (const PackedTile& tile : tiles) {
    begin.emplace_hint(begin.end(), tile.number, size);
    size += tile.sums.size();
    voxels += tile.voxels;
    points_left_out -= tile.points;
  }
  begin.emplace_hint(begin.end(), kNoTile, size);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(size);
  for (const PackedTile& tile : tiles) bytes.insert(bytes.end(), tile.sums.begin(), tile.sums.end());
  if (const auto before = views_.find(sweep); before != views_.end()) forget(before);
  const bool with_intensity = !points.intensity.empty() && !tiles.empty();
  View view{std::move(begin), StoredBytes(store_, std::move(bytes)), voxels, with_intensity, points_left_out};
  note_change(view);
  views_.emplace(sweep, std::move(view));
}

void VoxelCloud::withdraw(SweepNumber sweep) {
  const auto view = views_.find(sweep);
  if (view == views_.end()) throw std::invalid_argument("VoxelCloud: no such sweep");
  forget(view);
}

void VoxelCloud::forget(std::map<SweepNumber, View>::iterator view) {
  note_change(view->second);
  views_.erase(view);
}

void VoxelCloud::note_change(const View& view) {
  for (const auto& [tile, begin] : view.begin) {
    if (tile != kNoTile) changed_.insert(tile);
  }
}

std::vector<VoxelCloud::TileNumber> VoxelCloud::take_changed_tiles() {
  const std::set<TileNumber> changed = std::exchange(changed_, {});
  return {changed.begin(), changed.end()};
}

Eigen::AlignedBox3d VoxelCloud::box_of(TileNumber tile) const {
  const Eigen::Vector3d low = corner_of(tile << kTileBits);
  constexpr double kSide = 1 << (kTileBits / 3);
  return {low * voxel_m_, (low + Eigen::Vector3d::Constant(kSide)) * voxel_m_};
}

std::vector<VoxelCloud::TileNumber> VoxelCloud::tiles() const {
  std::set<TileNumber> tiles;
  for (const auto& [sweep, view] : views_) {
    for (const auto& [tile, begin] : view.begin) tiles.insert(tile);
  }
  tiles.erase(kNoTile);
  return {tiles.begin(), tiles.end()};
}

TileSums VoxelCloud::sums_of(TileNumber tile, SweepNumber end) const {
  TileSums sums;
  for (auto sweep = views_.begin(); sweep != views_.end() && sweep->first < end; ++sweep) {
    const View& view = sweep->second;
    const auto part = view.begin.find(tile);
    if (part == view.begin.end()) continue;
    sums.add(view.sums.fetch(part->second, std::next(part)->second), tile << kTileBits, view.with_intensity);
  }
  return sums;
}

PointCloud VoxelCloud::centroids_of(TileNumber tile) const {
  const bool with_intensity = std::any_of(views_.begin(), views_.end(), [tile](const auto& view) {
    return view.second.with_intensity && view.second.begin.contains(tile);
  });
  PointCloud cloud;
  Centroids centroids(voxel_m_, with_intensity, cloud);
  for (TileSums sums = sums_of(tile); sums.next();) centroids.append(sums.cube());
  return cloud;
}

PointCloud VoxelCloud::centroids(SweepNumber end) const {
  bool with_intensity = false;
  std::size_t most_voxels = 0;
  for (auto sweep = views_.begin(); sweep != views_.lower_bound(end); ++sweep) {
    with_intensity |= sweep->second.with_intensity;
    most_voxels = std::max(most_voxels, sweep->second.voxels);
  }
  PointCloud cloud;
  cloud.points.reserve(most_voxels);
  cloud.normals.reserve(most_voxels);
  if (with_intensity) cloud.intensity.reserve(most_voxels);
  Centroids centroids(voxel_m_, with_intensity, cloud);
  for (const TileNumber tile : tiles()) {
    for (TileSums sums = sums_of(tile, end); sums.next();) centroids.append(sums.cube());
  }
  return cloud;
}

std::size_t VoxelCloud::size() const {
  std::size_t size = 0;
  for (const TileNumber tile : tiles()) {
    for (TileSums sums = sums_of(tile); sums.next();) size += sums.cube().size();
  }
  return size;
}

std::uint64_t VoxelCloud::points_out_of_extent() const {
  std::uint64_t count = 0;
  for (const auto& [sweep, view] : views_) count += view.points_out_of_extent;
  return count;
}

}  // namespace scanway
