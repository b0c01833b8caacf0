#pragma once

#include <cstdint>
#include <vector>

#include "common/cloud/sweep.h"
#include "common/robot/robot.h"
#include "modules/simulator/core/laser/beam.h"
#include "modules/simulator/core/laser/scan_pattern.h"
#include "modules/simulator/core/world/world.h"

namespace scanway::simulator {

struct SweepConfig {
  std::uint64_t seed = 0;
  int thin = 1;  ///< Only every thin-th line, and of it every thin-th beam; what is left is the same as without.
  Utime start = 946'684'801 * kMicrosecondsPerSecond;  ///< When the pan begins to turn.
  double tilt = 0.0;                                   ///< Of the pan-tilt, radians, held.
  int people = 0;                                      ///< Who walk about near the robot.
};

/// A sweep as the scanner counts it: row after row, one a line.
struct RawSweep {
  ScanPattern pattern;
  int thin = 1;
  int lines = 0, beams = 0;  ///< Of what was kept.
  double range_scale_m = 0.001;
  std::vector<BeamReading> readings;

  /// Line and beam of the pattern.
  int line_of(int row) const { return row * thin; }
  int beam_of(int column) const { return column * thin; }
  const BeamReading& reading(int row, int column) const {
    return readings[static_cast<std::size_t>(row) * static_cast<std::size_t>(beams) + static_cast<std::size_t>(column)];
  }
};

RawSweep simulate_lines(const World& world, const Robot& robot, const Pose& X_world_base, const SweepConfig& config);
/// The same with a ray caster of the world (its ground and its objects) that already stands.
RawSweep simulate_lines(const RayCaster& world, const Robot& robot, const Pose& X_world_base,
                        const SweepConfig& config);
RayCaster caster_of(const World& world);

/// A sweep in `base`, and what each of its points belongs to.
struct LabelledSweep {
  Sweep sweep;  ///< Without orientation.
  std::vector<Label> labels;
};

/// The points of a raw sweep, each from where its beam truly left: what a perfect assembler makes of it. Points on the
/// robot itself are left out unless `keep_body`: those above its footprint and below its height.
LabelledSweep points_of(const RawSweep& raw, const Robot& robot, bool keep_body = false);

}  // namespace scanway::simulator
