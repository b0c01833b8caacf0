#include "modules/tools/arguments/arguments.h"
#include "modules/tools/simulate/simulate.h"
#include "modules/tools/simulate/simulate_compare.h"
#include "modules/tools/simulate/simulate_places.h"

namespace scanway::tools {

namespace {

CLI::Option* add_world(CLI::App* command, std::string& world, const std::string& help) {
  return command->add_option("--world", world, help)->required();
}

CLI::Option* add_seed(CLI::App* command, std::uint64_t& seed) {
  return command->add_option("--seed", seed, "Another seed is another world of the kind")->capture_default_str();
}

void add_simulated_sweep(CLI::App* simulate, Action& action) {
  static SimulateSweepOptions options;
  CLI::App* sweep = simulate->add_subcommand("sweep", "A sweep: a labelled cloud, or a log of the devices' messages");
  add_world(sweep, options.world, "One of `scanway simulate worlds`");
  add_seed(sweep, options.seed);
  sweep->add_option("--pose", options.poses, "Where the robot stands, m, m, rad; again for more sweeps in a log")
      ->required()
      ->type_name("X,Y,YAW");
  sweep->add_option("--thin", options.thin, "Only every K-th line, and of it every K-th beam")
      ->check(CLI::Range(1, 64));
  sweep->add_option("--people", options.people, "Persons who walk about near the robot while it scans")
      ->check(CLI::Range(0, 50))
      ->capture_default_str();
  sweep->add_option("--robot", options.robot, "Robot file (default: ERA-Mobi with its devices' sizes)");
  sweep->add_flag("--body", options.body, "Keep the points on the robot itself");
  sweep->add_option("-o,--output", options.output, "FILE.pcd, or FILE.lcm for a log")->required();
  sweep->callback([&action] { action = [] { return run_simulate_sweep(options); }; });
}

void add_simulated_truth(CLI::App* simulate, Action& action) {
  static SimulateTruthOptions options;
  CLI::App* truth = simulate->add_subcommand("truth", "The world's own grid as a map file");
  add_world(truth, options.world, "One of `scanway simulate worlds`");
  add_seed(truth, options.seed);
  truth->add_option("--resolution", options.resolution_m, "Edge of a cell, m")->check(CLI::Range(0.005, 1.0));
  truth->add_option("--robot", options.robot, "Robot file: its climbable step and height");
  truth->add_option("-o,--output", options.output, "MAP.yaml")->required();
  truth->callback([&action] { action = [] { return run_simulate_truth(options); }; });
}

void add_simulated_places(CLI::App* simulate, Action& action) {
  static SimulatePlacesOptions options;
  CLI::App* places = simulate->add_subcommand("places", "Places on a way through the world that the robot can drive");
  add_world(places, options.world, "One of `scanway simulate worlds`");
  add_seed(places, options.seed);
  places->add_option("--count", options.count, "How many")->check(CLI::Range(1, 1000))->capture_default_str();
  places->add_option("--spacing", options.spacing_m, "m from one to the next; 0: spread over the whole way")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  places->add_flag("--in-map", options.in_map, "In the frame of the map that is made on the bus");
  places->add_option("--lcm-url", options.lcm_url, "The bus, for --in-map");
  places->callback([&action] { action = [] { return run_simulate_places(options); }; });
}

void add_comparison(CLI::App* simulate, Action& action) {
  static SimulateCompareOptions options;
  CLI::App* compare = simulate->add_subcommand("compare", "Poses and cost map of a replayed log against the truth");
  compare->add_option("folder", options.folder, "What scanway replay made of a simulated robot's log")->required();
  add_world(compare, options.world, "The simulator's");
  add_seed(compare, options.seed);
  compare->add_flag("--json", options.json, "One JSON document on stdout");
  compare->callback([&action] { action = [] { return run_simulate_compare(options); }; });
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  CLI::App* simulate = app.add_subcommand("simulate", "Sweeps and maps of made-up places, with their truth");
  simulate->require_subcommand(1);
  add_simulated_sweep(simulate, action);
  add_simulated_truth(simulate, action);
  simulate->add_subcommand("worlds", "The worlds that there are")->callback([&action] {
    action = [] { return run_simulate_worlds(); };
  });
  add_simulated_places(simulate, action);
  add_comparison(simulate, action);
}

}  // namespace scanway::tools
