/// The command line of `scanway`: every subcommand's words and flags. What a subcommand does is in its own file.

#include <cstdio>
#include <functional>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "modules/tools/command.h"
#include "modules/tools/decode_erratic.h"
#include "modules/tools/decode_lms.h"
#include "modules/tools/decode_schunk.h"
#include "modules/tools/decode_xsens.h"
#include "modules/tools/drive/drive.h"
#include "modules/tools/import_clouds.h"
#include "modules/tools/info.h"
#include "modules/tools/octomap_clouds.h"
#include "modules/tools/plan.h"
#include "modules/tools/plan_scenario.h"
#include "modules/tools/register.h"
#include "modules/tools/replay.h"
#include "modules/tools/simulate.h"
#include "modules/tools/simulate_compare.h"
#include "modules/tools/simulate_places.h"
#include "modules/tools/spy.h"

namespace scanway::tools {
namespace {

constexpr int kBadInput = 2;

/// Runs what the chosen subcommand asks for; set while the command line is parsed.
using Action = std::function<int()>;

void log_to_stderr() {
  auto logger = spdlog::stderr_color_st("scanway");
  logger->set_pattern("scanway: %v");
  spdlog::set_default_logger(logger);
}

/// "X,Y" as a flag's value.
CLI::Option* add_point(CLI::App* app, const std::string& flag, std::pair<double, double>& point,
                       const std::string& help) {
  return app->add_option(flag, point, help)->delimiter(',')->type_name("X,Y");
}

void add_import(CLI::App& app, Action& action) {
  static ImportCloudsOptions options;
  static std::pair<double, double> goal;
  static double height = 0.0;
  CLI::App* import = app.add_subcommand("import", "Make a log of what other programs recorded");
  import->require_subcommand(1);
  CLI::App* clouds = import->add_subcommand("clouds", "A log of sweeps from cloud files: PCD, PLY, 3DTK .3d, VTK");
  clouds->add_option("files", options.files, "The clouds, in the order of the scans")->required();
  auto* poses = clouds->add_option("--poses", options.poses, "Reference poses: name and 3x4 matrix, a line a scan");
  clouds->add_option("--orientation", options.orientation, "Orientations of the same form, without a reference")
      ->excludes(poses);
  clouds->add_option("-o,--output", options.output, "The log to write")->required();
  clouds->add_option("--robot", options.robot, "Robot file (default: ERA-Mobi)");
  clouds->add_option("--heading-sigma-deg", options.heading_sigma_deg, "Disturbs the tracker's heading")
      ->check(CLI::Range(0.0, 180.0));
  clouds->add_option("--tilt-sigma-deg", options.tilt_sigma_deg, "Disturbs the tracker's roll and pitch")
      ->check(CLI::Range(0.0, 180.0));
  clouds->add_option("--seed", options.seed, "Of the disturbance");
  auto* height_flag = clouds->add_option("--sensor-height", height, "Of the sensor above the ground, m")
                          ->check(CLI::Range(0.01, 100.0));
  auto* goal_flag = add_point(clouds, "--goal", goal, "Where to plan to, m in the map frame");
  clouds->callback([&action, height_flag, goal_flag] {
    if (height_flag->count() > 0) options.sensor_height_m = height;
    if (goal_flag->count() > 0) options.goal_m = goal;
    action = [] { return run_import_clouds(options); };
  });
}

void add_register(CLI::App& app, Action& action) {
  static RegisterOptions options;
  static std::array<double, 4> orientation{};
  CLI::App* command = app.add_subcommand("register", "The pose of one cloud in another's frame, with a verdict");
  command->add_option("source", options.source, "The cloud to move")->required();
  command->add_option("target", options.target, "The cloud that stays")->required();
  auto* flag =
      command
          ->add_option("--orientation", orientation, "R_target_source as a tracker gives it, a quaternion qw,qx,qy,qz")
          ->delimiter(',')
          ->type_name("QW,QX,QY,QZ");
  command->add_flag("--json", options.json, "One JSON document on stdout");
  command->callback([&action, flag] {
    if (flag->count() > 0) options.orientation_wxyz = orientation;
    action = [] { return run_register(options); };
  });
}

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

void add_octomap(CLI::App& app, Action& action) {
  static OctomapOptions options;
  CLI::App* command = app.add_subcommand("octomap", "The OctoMap of clouds at known poses");
  command->add_option("clouds", options.clouds, "The clouds, in the order of insertion")->required();
  command->add_option("--poses", options.poses, "Poses of the clouds: name and 3x4 matrix, a line a cloud")->required();
  command->add_option("--resolution", options.resolution_m, "Edge of a voxel, m")
      ->required()
      ->check(CLI::Range(0.001, 100.0));
  command->add_option("--max-range", options.max_range_m, "Beams are cut off here, m (default: they are not)");
  command->add_flag("--discretize", options.discretize, "One ray a voxel that is hit, instead of one a point");
  command->add_option("-o,--output", options.output, "MAP.ot or MAP.bt")->required();
  command->add_flag("--json", options.json, "One JSON document on stdout");
  command->callback([&action] { action = [] { return run_octomap(options); }; });
}

void add_replay(CLI::App& app, Action& action) {
  static ReplayOptions options;
  CLI::App* command = app.add_subcommand("replay", "A log in; map, cost map, path and pictures out");
  command->add_option("log", options.log, "The log")->required();
  auto* output = command->add_option("-o,--output", options.output, "Folder for the products");
  command->add_option("--robot", options.robot, "Robot file in place of the log's own configuration");
  command->add_option("--resume", options.resumed, "Folder of kept sweeps: the log goes on with their map");
  auto* keep = command->add_option("--keep", options.kept, "Folder to keep the map's sweeps in, for --resume");
  static bool verifies = false;
  auto* verify = command->add_flag("--verify", verifies, "Compare the log's own products with what its inputs give");
  verify->excludes(output)->excludes(keep);
  command
      ->add_option("--played", options.played, "The log that was played to the processes: name what they did not use")
      ->needs(verify);
  command->callback([&action] {
    if (!verifies && options.output.empty()) throw CLI::RequiredError("--output or --verify");
    action = [] { return verifies ? run_verify(options) : run_replay(options); };
  });
}

void add_info(CLI::App& app, Action& action) {
  static InfoOptions options;
  CLI::App* command = app.add_subcommand("info", "What a log holds, and whether it is whole");
  command->add_option("log", options.log, "The log")->required();
  command->add_flag("--json", options.json, "One JSON document on stdout");
  command->callback([&action] { action = [] { return run_info(options); }; });
}

void add_spy(CLI::App& app, Action& action) {
  static SpyOptions options;
  CLI::App* command = app.add_subcommand("spy", "What is on the bus: rates, gaps, bad messages, values of a channel");
  command->add_option("channel", options.channel, "Show this channel's values instead of the table of all");
  command->add_option("--lcm-url", options.lcm_url, "The bus (default: LCM_DEFAULT_URL, or multicast on this machine)");
  command->add_option("--seconds", options.seconds, "Listen for so long")->check(CLI::Range(0.0, 1e9));
  command->add_flag("--once", options.once, "One table, or the next message of the channel");
  command->add_flag("--json", options.json, "JSON lines on stdout");
  command->add_option("--elements", options.elements, "How many elements of an array to show")->capture_default_str();
  command->add_option("--ask", options.ask, "Ask for the objects that this channel's senders hold");
  command->add_option("--relay", options.relay, "Pass everything on to this bus, objects whole, for LCM's own tools");
  command->callback([&action] { action = [] { return run_spy(options); }; });
}

void add_simulate(CLI::App& app, Action& action) {
  static SimulateSweepOptions sweep_options;
  static SimulateTruthOptions truth_options;
  static SimulatePlacesOptions places_options;
  static SimulateCompareOptions compare_options;
  CLI::App* simulate = app.add_subcommand("simulate", "Sweeps and maps of made-up places, with their truth");
  simulate->require_subcommand(1);
  CLI::App* sweep = simulate->add_subcommand("sweep", "A sweep: a labelled cloud, or a log of the devices' messages");
  CLI::App* truth = simulate->add_subcommand("truth", "The world's own grid as a map file");
  CLI::App* worlds = simulate->add_subcommand("worlds", "The worlds that there are");
  CLI::App* places = simulate->add_subcommand("places", "Places on a way through the world that the robot can drive");
  sweep->add_option("--world", sweep_options.world, "One of `scanway simulate worlds`")->required();
  sweep->add_option("--seed", sweep_options.seed, "Another seed is another world of the kind")->capture_default_str();
  sweep->add_option("--pose", sweep_options.poses, "Where the robot stands, m, m, rad; again for more sweeps in a log")
      ->required()
      ->type_name("X,Y,YAW");
  sweep->add_option("--thin", sweep_options.thin, "Only every K-th line, and of it every K-th beam")
      ->check(CLI::Range(1, 64));
  sweep->add_option("--people", sweep_options.people, "Persons who walk about near the robot while it scans")
      ->check(CLI::Range(0, 50))
      ->capture_default_str();
  sweep->add_option("--robot", sweep_options.robot, "Robot file (default: ERA-Mobi with its devices' sizes)");
  sweep->add_flag("--body", sweep_options.body, "Keep the points on the robot itself");
  sweep->add_option("-o,--output", sweep_options.output, "FILE.pcd, or FILE.lcm for a log")->required();
  truth->add_option("--world", truth_options.world, "One of `scanway simulate worlds`")->required();
  truth->add_option("--seed", truth_options.seed, "Another seed is another world of the kind")->capture_default_str();
  truth->add_option("--resolution", truth_options.resolution_m, "Edge of a cell, m")->check(CLI::Range(0.005, 1.0));
  truth->add_option("--robot", truth_options.robot, "Robot file: its climbable step and height");
  truth->add_option("-o,--output", truth_options.output, "MAP.yaml")->required();
  CLI::App* compare = simulate->add_subcommand("compare", "Poses and cost map of a replayed log against the truth");
  compare->add_option("folder", compare_options.folder, "What scanway replay made of a simulated robot's log")
      ->required();
  compare->add_option("--world", compare_options.world, "The simulator's")->required();
  compare->add_option("--seed", compare_options.seed, "The simulator's")->capture_default_str();
  compare->add_flag("--json", compare_options.json, "One JSON document on stdout");
  places->add_option("--world", places_options.world, "One of `scanway simulate worlds`")->required();
  places->add_option("--seed", places_options.seed, "Another seed is another world of the kind")->capture_default_str();
  places->add_option("--count", places_options.count, "How many")->check(CLI::Range(1, 1000))->capture_default_str();
  places->add_option("--spacing", places_options.spacing_m, "m from one to the next; 0: spread over the whole way")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  places->add_flag("--in-map", places_options.in_map, "In the frame of the map that is made on the bus");
  places->add_option("--lcm-url", places_options.lcm_url, "The bus, for --in-map");
  sweep->callback([&action] { action = [] { return run_simulate_sweep(sweep_options); }; });
  truth->callback([&action] { action = [] { return run_simulate_truth(truth_options); }; });
  compare->callback([&action] { action = [] { return run_simulate_compare(compare_options); }; });
  places->callback([&action] { action = [] { return run_simulate_places(places_options); }; });
  worlds->callback([&action] { action = [] { return run_simulate_worlds(); }; });
}

void add_command(CLI::App& app, Action& action) {
  static CommandOptions options;
  CLI::App* command = app.add_subcommand("command", "Tell the pan-tilt what to do");
  command->add_option("what", options.what, "sweep, move, turn, reference, stop, fast-stop or acknowledge")
      ->required()
      ->check(CLI::IsMember({"sweep", "move", "turn", "reference", "stop", "fast-stop", "acknowledge"}));
  command->add_option("--pan-deg", options.pan_deg, "move: where to");
  command->add_option("--tilt-deg", options.tilt_deg, "move: where to; sweep: the tilt to hold");
  command->add_option("--pan-speed-deg-s", options.pan_speed_deg_s, "turn: with its sign; sweep: while it scans; move");
  command->add_option("--tilt-speed-deg-s", options.tilt_speed_deg_s, "turn: with its sign; move");
  command->add_flag("--registered", options.registered, "sweep: wait for its place in the map, too");
  command->add_option("--lcm-url", options.lcm_url, "The bus (default: LCM_DEFAULT_URL, or multicast on this machine)");
  command->callback([&action] { action = [] { return run_command(options); }; });
}

void add_drive(CLI::App& app, Action& action) {
  static DriveOptions options;
  CLI::App* command = app.add_subcommand("drive", "Drive the robot along the planner's path to a goal");
  add_point(command, "goal", options.goal_m, "m, in the map's frame")->required();
  command->add_option("--speed-m-s", options.speed_m_s, "As fast as this")
      ->check(CLI::Range(0.01, 2.0))
      ->capture_default_str();
  command->add_option("--lcm-url", options.lcm_url, "The bus (default: LCM_DEFAULT_URL, or multicast on this machine)");
  command->callback([&action] { action = [] { return run_drive(options); }; });
}

void add_decode(CLI::App& app, Action& action) {
  struct Device {
    const char* name;
    const char* help;
    int (*run)(const std::string&);
  };
  static constexpr Device kDevices[] = {
      {"lms", "SICK LMS5xx: CoLa-A or CoLa-B telegrams", run_decode_lms},
      {"schunk", "SCHUNK PW-70: Motion Protocol frames on CAN", run_decode_schunk},
      {"xsens", "Xsens tracker: MTData and MTData2", run_decode_xsens},
      {"erratic", "ERA-Mobi base: its serial packets", run_decode_erratic},
  };
  static std::string file;
  CLI::App* decode = app.add_subcommand("decode", "A device's recorded bytes as JSON lines, what is broken marked");
  decode->require_subcommand(1);
  for (const Device& device : kDevices) {
    CLI::App* command = decode->add_subcommand(device.name, device.help);
    command->add_option("file", file, "What the device sent")->required();
    command->callback([&action, run = device.run] { action = [run] { return run(file); }; });
  }
}

/// The error's one line, and the exit status for bad input.
int refuse(const std::string& message) {
  std::fputs(fmt::format("scanway: {}\n", printable(message)).c_str(), stderr);
  return kBadInput;
}

int run(int argc, char** argv) {
  CLI::App app{"Scanway: registered maps and paths from the 3D scans of a stop-and-scan robot"};
  app.require_subcommand(1);
  app.fallthrough();
  unsigned threads = 0;
  app.add_option("--threads", threads, "Threads to compute with (default: as many as there are cores)")
      ->check(CLI::Range(1u, 256u));
  Action action;
  add_import(app, action);
  add_register(app, action);
  add_plan(app, action);
  add_octomap(app, action);
  add_replay(app, action);
  add_info(app, action);
  add_spy(app, action);
  add_simulate(app, action);
  add_command(app, action);
  add_drive(app, action);
  add_decode(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return refuse(fmt::format("{}; see scanway --help", error.what()));
  }
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency()));
  return action();
}

}  // namespace
}  // namespace scanway::tools

int main(int argc, char** argv) {
  scanway::tools::log_to_stderr();
  try {
    return scanway::tools::run(argc, argv);
  } catch (const scanway::InputError& error) {
    return scanway::tools::refuse(error.what());
  } catch (const std::bad_alloc&) {
    return scanway::tools::refuse("not enough memory for this input");
  } catch (const std::exception& error) {
    return scanway::tools::refuse(error.what());
  }
}
