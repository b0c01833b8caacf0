#include <memory>
#include <string>

#include "modules/tools/arguments/arguments.h"
#include "modules/tools/drive/mapper_order.h"
#include "modules/tools/map/export_map.h"
#include "modules/tools/map/fetch_map.h"
#include "modules/tools/map/import_map.h"
#include "modules/tools/map/save_map.h"

namespace scanway::tools {
namespace {

void add_save(CLI::App& map, Action& action) {
  static SaveMapOptions options;
  CLI::App* save = map.add_subcommand("save", "The map of kept sweeps as one folder, whole or not at all");
  save->add_option("sweeps", options.sweeps, "What scanway-mapper --state or scanway replay --keep kept; a saved map")
      ->required();
  save->add_option("-o,--output", options.output, "The folder")->required();
  save->add_option("--robot", options.robot, "Robot file (default: the saved map's, or ERA-Mobi)");
  save->callback([&action] { action = [] { return run_save_map(options); }; });
}

void add_check(CLI::App& map, Action& action) {
  static std::string folder;
  CLI::App* check = map.add_subcommand("check", "Whether a saved map is what was saved");
  check->add_option("folder", folder, "The saved map")->required();
  check->callback([&action] { action = [] { return run_check_map(folder); }; });
}

void add_fetch(CLI::App& map, Action& action) {
  static FetchMapOptions options;
  CLI::App* fetch = map.add_subcommand("fetch", "The map over a slow link, from scanway-link at its other end");
  fetch->add_option("-o,--output", options.output, "The folder to save it in")->required();
  fetch->add_option("--lcm-url", options.lcm_url, "The link's bus (default: LCM_DEFAULT_URL)");
  fetch->add_option("--cloud", options.detail.cloud_m, "One point a voxel of so many metres; 0: no cloud")
      ->check(CLI::Range(0.0, 4.0))
      ->capture_default_str();
  fetch->add_option("--octomap", options.detail.octomap_m, "The OctoMap's finest leaf, m; 0: no OctoMap")
      ->check(CLI::Range(0.0, 4.0))
      ->capture_default_str();
  fetch->add_option("--limit-s", options.limit_s, "Give up when it is not whole by then")
      ->check(CLI::Range(1.0, 1e6))
      ->capture_default_str();
  fetch->callback([&action] { action = [] { return run_fetch_map(options); }; });
}

void add_order(CLI::App& map, Action& action, const std::string& name, const std::string& what,
               const std::string& of_name, int (*run)(const MapperOrder&)) {
  const auto order = std::make_shared<MapperOrder>();
  CLI::App* command = map.add_subcommand(name, what);
  command->add_option("name", order->name, of_name)->required();
  command->add_option("--lcm-url", order->lcm_url, "The bus (default: LCM_DEFAULT_URL)");
  command->callback([&action, order, run] { action = [order, run] { return run(*order); }; });
}

void add_import_map(CLI::App& import, Action& action) {
  static ImportMapOptions options;
  CLI::App* map = import.add_subcommand("map", "A map to plan on, of an OctoMap or of map_server's files");
  map->add_option("map", options.map, "OctoMap (.bt, .ot) or map_server's .yaml")->required();
  map->add_option("-o,--output", options.output, "MAP.yaml")->required();
  map->add_option("--robot", options.robot, "Robot file: its climbable step and height (default: ERA-Mobi)");
  map->add_option("--ground-z", options.ground_z_m, "Height of an OctoMap's ground in its frame, m")
      ->check(CLI::Range(-1000.0, 1000.0))
      ->capture_default_str();
  map->callback([&action] { action = [] { return run_import_map(options); }; });
}

}  // namespace

void add_map(CLI::App& app, Action& action) {
  CLI::App* map = app.add_subcommand("map", "Saved maps, and the map of another machine");
  map->require_subcommand(1);
  add_save(*map, action);
  add_check(*map, action);
  add_fetch(*map, action);
  add_order(*map, action, "withdraw", "Take a sweep out of the live mapper's map",
            "The sweep's name, as its registration says it", run_withdraw);
  add_order(*map, action, "keep", "Have the live mapper save its map, whole, in the folder of its --maps",
            "The name of the new folder there", run_keep_map);
  add_import_map(*app.get_subcommand("import"), action);
}

void add_export(CLI::App& app, Action& action) {
  static ExportMapOptions options;
  CLI::App* command = app.add_subcommand("export", "A product of a saved map as a file for other programs");
  command->add_option("folder", options.folder, "The saved map")->required();
  command->add_option("-o,--output", options.output, "FILE.pcd, .ply, .las, .bt, .ot, or .yaml with its .pgm")
      ->required();
  command->callback([&action] { action = [] { return run_export_map(options); }; });
}

}  // namespace scanway::tools
