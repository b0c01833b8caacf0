#include "modules/replay/products.h"

#include <fmt/format.h>

#include "common/picture/pictures.h"
#include "modules/mapper/saving/map_products.h"

namespace scanway {
namespace {

/// Both paths, the mode in the first column.
std::string path_csv(const PlannerNode& planner) {
  std::string text = "mode,x_m,y_m,heading_rad,time_s,speed_m_s\n";
  for (const auto* path : {&planner.without_embodiment(), &planner.with_embodiment()}) {
    if (!*path) continue;
    for (std::size_t i = 0; i < (*path)->pose_x_m.size(); ++i) {
      text += fmt::format("{},{},{},{},{},{}\n", (*path)->mode, (*path)->pose_x_m[i], (*path)->pose_y_m[i],
                          (*path)->pose_heading_rad[i], (*path)->pose_time_s[i], (*path)->pose_speed_m_s[i]);
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

}  // namespace

std::map<std::string, std::string> write_products(const MapperNode& mapper, const PlannerNode& planner,
                                                  const ProductFolder& folder) {
  auto digests = write_map_products(mapper, folder);
  const std::string path = path_csv(planner);
  folder.write("path.csv", path);
  draw_path(folder.path_of("path.png"), mapper.mapper().map().cost_map(), picture_of(planner));
  digests["path"] = digest_text(path);
  return digests;
}

}  // namespace scanway
