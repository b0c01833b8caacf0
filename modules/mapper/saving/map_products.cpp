#include "modules/mapper/saving/map_products.h"

#include <span>
#include <string_view>

#include <fmt/format.h>

#include "common/cloud/write_cloud.h"
#include "common/files/read_file.h"
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

}  // namespace

std::string digest_text(std::string_view bytes) {
  return hex(digest({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
}

std::map<std::string, std::string> write_map_products(const MapperNode& mapper, const ProductFolder& folder) {
  const Map& map = mapper.mapper().map();
  const PointCloud cloud = map.cloud().centroids();
  write_pcd(folder.path_of("map.pcd"), cloud);
  write_ply(folder.path_of("map.ply"), cloud);
  const std::string octomap = map.occupancy_tree().ot_bytes();
  folder.write("map.ot", octomap);
  folder.write("map.bt", map.occupancy_tree().bt_bytes());
  write_map(map.cost_map(), folder.path_of("costmap.yaml"));
  folder.write("trajectory.tum", trajectory_tum(mapper.mapper().trajectory()));
  draw_cloud_from_above(folder.path_of("map.png"), cloud, kCutHeight);
  draw_cost_map(folder.path_of("costmap.png"), map.cost_map());
  return {{"map", digest_text(read_file(folder.path_of("map.pcd")))},
          {"octomap", digest_text(octomap)},
          {"costmap", hex(mapper.published().cost_map_digest())}};
}

}  // namespace scanway
