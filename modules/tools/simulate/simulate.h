#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace scanway::tools {

struct SimulateSweepOptions {
  std::string world;
  std::uint64_t seed = 1;
  std::vector<std::string> poses;  ///< "x,y,yaw": metres and radians in the world's frame; several only for a log.
  int thin = 1;                    ///< Every thin-th line, and of it every thin-th beam.
  int people = 0;                  ///< Who walk about near the robot.
  std::string robot;
  bool body = false;   ///< Keep the points on the robot itself.
  std::string output;  ///< *.pcd, or *.lcm or *.lcmlog.
};

/// `scanway simulate sweep`: a sweep of a simulated robot as a cloud in `base`, or the raw messages of its devices as a
/// log; the exact poses in FILE.pose, the tracker's orientations in FILE.orientation. Throws InputError.
int run_simulate_sweep(const SimulateSweepOptions& options);

struct SimulateTruthOptions {
  std::string world;
  std::uint64_t seed = 1;
  std::string robot;
  double resolution_m = 0.01;
  std::string output;  ///< MAP.yaml
};

/// `scanway simulate truth`: the world's own grid as MAP.yaml and MAP.pgm, drop-offs being occupied, and the drop-offs
/// alone as MAP_drop_off.yaml and .pgm. Throws InputError.
int run_simulate_truth(const SimulateTruthOptions& options);

/// `scanway simulate worlds`: the worlds, one line each.
int run_simulate_worlds();

}  // namespace scanway::tools
