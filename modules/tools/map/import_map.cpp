#include "modules/tools/map/import_map.h"

#include <fmt/format.h>

#include <filesystem>

#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/read_file.h"
#include "common/grid/map_file.h"
#include "common/octree/octree_file.h"
#include "modules/tools/map/octree_projection.h"

namespace scanway::tools {
namespace {

CostMap read_any_map(const ImportMapOptions& options, const Robot& robot) {
  const std::string end = std::filesystem::path(options.map).extension();
  if (end == ".yaml") return read_map(options.map);
  if (end == ".bt" || end == ".ot") {
    const OctreeFile tree(read_file(options.map), options.map);
    return project(tree, {options.ground_z_m, robot.body.climbable_step_m, robot.body.height_m}, options.map);
  }
  throw InputError(printable(options.map) + ": is no map by its name; name a .bt, .ot or .yaml file");
}

}  // namespace

int run_import_map(const ImportMapOptions& options) {
  if (!options.output.ends_with(".yaml")) {
    throw InputError(printable(options.output) + ": a map's name ends with .yaml; give it with -o");
  }
  const Robot robot = options.robot.empty() ? Robot{} : load_robot(options.robot);
  const CostMap map = read_any_map(options, robot);
  const auto extent = bounds(map);
  if (!extent) {
    throw InputError(printable(options.map) + ": knows nothing where the robot would be; is --ground-z right?");
  }
  write_map(map, options.output);
  fmt::print("{}: {} x {} cells of {} m\n", printable(options.output), extent->width(), extent->height(),
             map.resolution_m);
  return 0;
}

}  // namespace scanway::tools
