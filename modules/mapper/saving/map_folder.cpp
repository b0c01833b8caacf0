#include "modules/mapper/saving/map_folder.h"

#include "common/config/robot_file.h"

namespace scanway {

void MapSave::commit(const Robot& robot) {
  save_.files().write(kRobotFile, robot_text(robot));
  save_.commit();
}

std::optional<Robot> robot_of_map(const std::string& folder) {
  if (!SavedFolder::is_one(folder)) return std::nullopt;
  const SavedFolder saved(folder);
  if (!saved.has(MapSave::kRobotFile)) return std::nullopt;
  return load_robot(saved.path_of(MapSave::kRobotFile));
}

}  // namespace scanway
