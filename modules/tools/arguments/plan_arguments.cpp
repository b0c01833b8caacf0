#include "modules/tools/arguments/arguments.h"
#include "modules/tools/plan/plan.h"
#include "modules/tools/plan/plan_scenario.h"

namespace scanway::tools {

void add_plan(CLI::App& app, Action& action) {
  static PlanOptions options;
  static PlanScenarioOptions scenario;
  CLI::App* command = app.add_subcommand("plan", "A path on a map file (map_server's PGM and YAML)");
  auto* scen = command->add_option("--scen", scenario.scenario, "Instead: every problem of a Moving AI scenario file");
  auto* map = command->add_option("map", options.map, "The map's YAML")->excludes(scen);
  auto* start = add_point(command, "--start", options.start_m, "m, in the map's frame")->excludes(scen)->needs(map);
  auto* goal = add_point(command, "--goal", options.goal_m, "m, in the map's frame")->excludes(scen)->needs(start);
  command->add_option("--mode", options.mode, "What the robot is taken for")
      ->check(CLI::IsMember({"point", "paper", "footprint"}))
      ->capture_default_str();
  command->add_option("--unknown", options.unknown, "What may be done with unknown cells")
      ->check(CLI::IsMember({"never", "price", "free"}))
      ->capture_default_str();
  static bool wanted = false;
  auto* smooth =
      command->add_flag("--smooth", wanted, "Straighten the path and round its corners (default: in mode footprint)");
  auto* cells = command->add_flag("--no-smooth", wanted, "Leave it as the search found it")->excludes(smooth);
  command->add_flag("--explain", options.explain, "Say what is in the way, and where");
  command->add_option("--robot", options.robot, "Robot file (default: ERA-Mobi)");
  command->add_option("-o,--output", options.output, "Folder for path.csv and path.png");
  command->add_flag("--json", options.json, "One JSON document on stdout");
  command->callback([&action, goal, scen, smooth, cells] {
    if (!smooth->empty()) options.smooth = true;
    if (!cells->empty()) options.smooth = false;
    if (scen->empty() && goal->empty()) throw CLI::RequiredError("MAP.yaml --start X,Y --goal X,Y, or --scen FILE");
    scenario.json = options.json;
    if (scen->empty()) action = [] { return run_plan(options); };
    if (!scen->empty()) action = [] { return run_plan_scenario(scenario); };
  });
}

}  // namespace scanway::tools
