#include "modules/tools/map/save_map.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cstdio>

#include "common/bus/memory_bus.h"
#include "common/config/robot_file.h"
#include "common/files/printable.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/mapper/saving/map_folder.h"
#include "modules/mapper/saving/map_products.h"

namespace scanway::tools {
namespace {

Robot robot_for(const SaveMapOptions& options) {
  if (!options.robot.empty()) return load_robot(options.robot);
  const std::optional<Robot> robot = robot_of_map(options.sweeps);
  if (!robot) spdlog::warn("{}: says no robot; took the built-in ERA-Mobi", printable(options.sweeps));
  return robot.value_or(Robot{});
}

}  // namespace

int run_save_map(const SaveMapOptions& options) {
  const Robot robot = robot_for(options);
  const SweepStore sweeps = saved_map(options.sweeps);
  MapSave save(options.output);
  save.sweeps().take_over(sweeps);
  MemoryBus nobody;
  MapperNode mapper(nobody, robot);
  mapper.restore(save.sweeps());
  mapper.finish();
  const auto digests = write_map_products(mapper, save.files());
  save.commit(robot);
  fmt::print("map of {} sweeps saved in {}\n", mapper.mapper().trajectory().size(), printable(options.output));
  for (const auto& [product, digest] : digests) fmt::print("{} {}\n", product, digest);
  return 0;
}

int run_check_map(const std::string& folder) {
  const SavedFolder saved(folder);
  fmt::print("{}: {} files, all as they were saved\n", printable(folder), saved.digests().size());
  return 0;
}

}  // namespace scanway::tools
