#include "modules/replay/products.h"

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

std::uint64_t digest_of(std::string_view bytes) {
  return digest({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

/// Lines of `timestamp tx ty tz qx qy qz qw`, as TUM's trajectory tools read them.
std::string trajectory_tum(const std::vector<TrajectoryPoint>& trajectory) {
  std::string text = "# timestamp_s tx ty tz qx qy qz qw (pose of the sweep in the map)\n";
  for (const TrajectoryPoint& point : trajectory) {
    const Eigen::Vector3d t = point.X_map_sweep.translation();
    const Eigen::Quaterniond q(point.X_map_sweep.linear());
    text += fmt::format("{}.{:06} {} {} {} {} {} {} {}\n", point.utime / kMicrosecondsPerSecond,
                        point.utime % kMicrosecondsPerSecond, t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }
  return text;
}

/// Both paths, the mode in the first column.
std::string path_csv(const PlannerNode& planner) {
  std::string text = "mode,x_m,y_m,heading_rad\n";
  for (const auto* path : {&planner.without_embodiment(), &planner.with_embodiment()}) {
    if (!*path) continue;
    for (std::size_t i = 0; i < (*path)->pose_x_m.size(); ++i) {
      text += fmt::format("{},{},{},{}\n", (*path)->mode, (*path)->pose_x_m[i], (*path)->pose_y_m[i],
                          (*path)->pose_heading_rad[i]);
    }
  }
  return text;
}

std::vector<Eigen::Vector2d> points_of(const std::optional<path_t>& path) {
  std::vector<Eigen::Vector2d> points;
  if (!path) return points;
  for (std::size_t i = 0; i < path->pose_x_m.size(); ++i) points.emplace_back(path->pose_x_m[i], path->pose_y_m[i]);
  return points;
}

PathPicture picture_of(const PlannerNode& planner) {
  PathPicture picture;
  if (const auto& path = planner.with_embodiment()) {
    picture.start_m = {path->start[0], path->start[1]};
    picture.goal_m = {path->goal[0], path->goal[1]};
  }
  picture.without_embodiment = points_of(planner.without_embodiment());
  picture.with_embodiment = points_of(planner.with_embodiment());
  return picture;
}

/// Where the ceiling is cut away for the picture: above what the robot could hit, with some walls to see.
constexpr double kCutHeight = 2.0;

void draw_pictures(const MapperNode& mapper, const PlannerNode& planner, const PointCloud& cloud,
                   const ProductFolder& folder) {
  const CostMap& cost_map = mapper.mapper().map().cost_map();
  draw_cloud_from_above(folder.path_of("map.png"), cloud, kCutHeight);
  draw_cost_map(folder.path_of("costmap.png"), cost_map);
  draw_path(folder.path_of("path.png"), cost_map, picture_of(planner));
}

}  // namespace

std::map<std::string, std::string> write_products(const MapperNode& mapper, const PlannerNode& planner,
                                                  const ProductFolder& folder) {
  const Map& map = mapper.mapper().map();
  const PointCloud cloud = map.cloud().centroids();
  write_pcd(folder.path_of("map.pcd"), cloud);
  write_ply(folder.path_of("map.ply"), cloud);
  const std::string octomap = map.occupancy_tree().ot_bytes();
  folder.write("map.ot", octomap);
  folder.write("map.bt", map.occupancy_tree().bt_bytes());
  write_map(map.cost_map(), folder.path_of("costmap.yaml"));
  folder.write("trajectory.tum", trajectory_tum(mapper.mapper().trajectory()));
  const std::string path = path_csv(planner);
  folder.write("path.csv", path);
  draw_pictures(mapper, planner, cloud, folder);
  return {{"map", hex(digest_of(read_file(folder.path_of("map.pcd"))))},
          {"octomap", hex(digest_of(octomap))},
          {"costmap", hex(static_cast<std::uint64_t>(mapper.published().cost_map_digest()))},
          {"path", hex(digest_of(path))}};
}

}  // namespace scanway
