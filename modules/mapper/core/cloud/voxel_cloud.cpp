#include "modules/mapper/core/cloud/voxel_cloud.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <stdexcept>
#include <utility>

#include "modules/mapper/core/cloud/packed_sums.h"
#include "modules/mapper/core/cloud/surface_normals.h"
#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

constexpr int kTileBits = 27;
constexpr VoxelCloud::TileNumber kNoTile = std::numeric_limits<VoxelCloud::TileNumber>::max();  // after all others

VoxelCloud::TileNumber tile_of(const VoxelSum& voxel) { return voxel.key >> kTileBits; }

}  // namespace

VoxelCloud::VoxelCloud(double voxel_m, std::shared_ptr<ByteStore> store)
    : voxel_m_(voxel_m), store_(std::move(store)) {}

void VoxelCloud::put(SweepNumber sweep, const MapPoints& points) {
  std::vector<VoxelSum> sums = voxel_sums(points, voxel_m_);
  set_normals(sums, points.origin, voxel_m_);
  const bool with_intensity = !points.intensity.empty() && !sums.empty();
  std::map<TileNumber, std::size_t> begin;
  std::vector<std::uint8_t> bytes;
  for (auto from = sums.begin(); from != sums.end();) {
    const TileNumber tile = tile_of(*from);
    const auto to = std::find_if(from, sums.end(), [tile](const VoxelSum& voxel) { return tile_of(voxel) != tile; });
    begin.emplace_hint(begin.end(), tile, bytes.size());
    pack({from, to}, tile << kTileBits, with_intensity, bytes);
    from = to;
  }
  begin.emplace_hint(begin.end(), kNoTile, bytes.size());
  if (const auto before = views_.find(sweep); before != views_.end()) forget(before);
  View view{std::move(begin), StoredBytes(store_, std::move(bytes)), with_intensity,
            points.points.size() - count_points(sums)};
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

std::vector<VoxelSum> VoxelCloud::sums_of(TileNumber tile, SweepNumber end) const {
  std::vector<VoxelSum> sums;
  for (auto sweep = views_.begin(); sweep != views_.end() && sweep->first < end; ++sweep) {
    const View& view = sweep->second;
    const auto part = view.begin.find(tile);
    if (part == view.begin.end()) continue;
    const std::vector<std::uint8_t> bytes = view.sums.fetch(part->second, std::next(part)->second);
    unpack(bytes, tile << kTileBits, view.with_intensity, sums);
  }
  add_up(sums);
  return sums;
}

PointCloud VoxelCloud::centroids_of(TileNumber tile) const {
  const bool with_intensity = std::any_of(views_.begin(), views_.end(), [tile](const auto& view) {
    return view.second.with_intensity && view.second.begin.contains(tile);
  });
  PointCloud cloud;
  append_centroids(sums_of(tile, std::numeric_limits<SweepNumber>::max()), voxel_m_, with_intensity, cloud);
  return cloud;
}

PointCloud VoxelCloud::centroids(SweepNumber end) const {
  const bool with_intensity =
      std::any_of(views_.begin(), views_.lower_bound(end), [](const auto& view) { return view.second.with_intensity; });
  PointCloud cloud;
  for (const TileNumber tile : tiles()) append_centroids(sums_of(tile, end), voxel_m_, with_intensity, cloud);
  return cloud;
}

std::size_t VoxelCloud::size() const {
  std::size_t size = 0;
  for (const TileNumber tile : tiles()) size += sums_of(tile, std::numeric_limits<SweepNumber>::max()).size();
  return size;
}

std::uint64_t VoxelCloud::points_out_of_extent() const {
  std::uint64_t count = 0;
  for (const auto& [sweep, view] : views_) count += view.points_out_of_extent;
  return count;
}

}  // namespace scanway
