#include "modules/mapper/saving/map_products.h"

#include <span>
#include <string_view>

#include <fmt/format.h>

#include "common/cloud/write_cloud.h"
#include "common/files/atomic_file.h"
#include "common/files/file_digest.h"
#include "common/grid/map_file.h"
#include "common/messages/digest.h"
#include "common/picture/pictures.h"

namespace scanway {
namespace {

/// Lines of `timestamp tx ty tz qx qy qz qw`, as TUM's trajectory tools read them.
std::string trajectory_tum(const std::vector<TrajectoryPoint>& trajectory) {
  std::string text = "# timestamp_s tx ty tz qx qy qz qw (pose of the sweep in the map)\n";
  for (const TrajectoryPoint& point : trajectory) {
    if (point.withdrawn) continue;
    const Eigen::Vector3d t = point.X_map_sweep.translation();
    const Eigen::Quaterniond q(point.X_map_sweep.linear());
    text += fmt::format("{}.{:06} {} {} {} {} {} {} {}\n", point.utime / kMicrosecondsPerSecond,
                        point.utime % kMicrosecondsPerSecond, t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }
  return text;
}

/// Where the ceiling is cut away for the picture: above what the robot could hit, with some walls to see.
constexpr double kCutHeight = 2.0;

/// As many points as a picture of 1,600 pixels needs: of a larger cloud it shows every second, third ...
constexpr std::size_t kPictured = 4'000'000;

CloudShape shape_of(const VoxelCloud& cloud) {
  CloudShape shape;
  for (const VoxelCloud::TileNumber tile : cloud.tiles()) {
    const PointCloud part = cloud.centroids_of(tile);
    shape.points += part.size();
    shape.with_intensity |= !part.intensity.empty();
    shape.with_normals |= !part.normals.empty();
  }
  return shape;
}

/// The cloud's files and its picture, with a tile of it in the memory at a time.
void write_cloud_products(const VoxelCloud& cloud, const ProductFolder& folder) {
  const CloudShape shape = shape_of(cloud);
  const std::size_t step = 1 + shape.points / kPictured;
  CloudWriter pcd(folder.path_of("map.pcd"), CloudWriter::Format::pcd, shape);
  CloudWriter ply(folder.path_of("map.ply"), CloudWriter::Format::ply, shape);
  PointCloud pictured;
  std::size_t next = 0;  // Of this tile's points.
  for (const VoxelCloud::TileNumber tile : cloud.tiles()) {
    const PointCloud part = cloud.centroids_of(tile);
    pcd.write(part);
    ply.write(part);
    for (; next < part.size(); next += step) pictured.points.push_back(part.points[next]);
    next -= part.size();
  }
  pcd.commit();
  ply.commit();
  draw_cloud_from_above(folder.path_of("map.png"), pictured, kCutHeight);
}

void write_octomap(const OccupancyTree& tree, const ProductFolder& folder) {
  AtomicFile file(folder.path_of("map.ot"));
  tree.write_ot([&file](std::string_view part) { file.write(part); });
  file.commit();
  folder.write("map.bt", tree.bt_bytes());
}

}  // namespace

std::string digest_text(std::string_view bytes) {
  return hex(digest({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
}

std::map<std::string, std::string> write_map_products(const MapperNode& mapper, const ProductFolder& folder) {
  const Map& map = mapper.mapper().map();
  write_cloud_products(map.cloud(), folder);
  write_octomap(map.occupancy_tree(), folder);
  write_map(map.cost_map(), folder.path_of("costmap.yaml"));
  folder.write("trajectory.tum", trajectory_tum(mapper.mapper().trajectory()));
  draw_cost_map(folder.path_of("costmap.png"), map.cost_map());
  return {{"map", hex(file_digest(folder.path_of("map.pcd")))},
          {"octomap", hex(file_digest(folder.path_of("map.ot")))},
          {"costmap", hex(mapper.published().cost_map_digest())}};
}

}  // namespace scanway
