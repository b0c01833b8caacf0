#include <array>
#include <utility>

#include "modules/tools/arguments/arguments.h"
#include "modules/tools/clouds/import_clouds.h"
#include "modules/tools/clouds/octomap_clouds.h"
#include "modules/tools/clouds/register.h"

namespace scanway::tools {

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

}  // namespace scanway::tools
