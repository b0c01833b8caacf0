#pragma once

#include <optional>
#include <string>

#include "common/files/saved_folder.h"
#include "common/robot/robot.h"
#include "modules/mapper/node/sweep_store.h"

namespace scanway {

/// A map on its way into a folder: its products, the robot file, and the sweeps that it is made of. All at once, or not
/// at all (saved_folder.h).
class MapSave {
 public:
  /// Throws InputError.
  explicit MapSave(const std::string& folder) : save_(folder), sweeps_(save_.files().path_of(kSavedSweeps)) {}

  const ProductFolder& files() const { return save_.files(); }
  /// Where the sweeps of the map are to be kept.
  const SweepStore& sweeps() const { return sweeps_; }
  void commit(const Robot& robot);

  static constexpr const char* kSavedSweeps = "sweeps";
  static constexpr const char* kRobotFile = "robot.yaml";

 private:
  FolderSave save_;
  SweepStore sweeps_;
};

/// The robot that a saved map was made for; nothing if `folder` is of kept sweeps alone. Throws InputError.
std::optional<Robot> robot_of_map(const std::string& folder);

}  // namespace scanway
