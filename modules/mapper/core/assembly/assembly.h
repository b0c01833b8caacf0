#pragma once

#include <cstdint>
#include <vector>

#include "common/cloud/sweep.h"
#include "common/robot/robot.h"
#include "modules/mapper/core/assembly/scan_line.h"
#include "modules/mapper/core/assembly/steadiness.h"

namespace scanway {

/// What a sweep is made of. Data from before and after it may be there and is not used.
struct AssemblyInput {
  std::int64_t sweep = 0;        ///< Its number.
  Utime started = 0, ended = 0;  ///< Of the pan's motion.
  std::vector<ScanLine> lines;   ///< By number; of the first echo.
  std::vector<PanTiltAngles> angles;
  std::vector<Orientation> orientations;  ///< In the order of their times.
};

/// How far to trust a sweep: what of it is there, and what was left out, in beams and lines.
struct AssemblyReport {
  std::int64_t lines = 0;          ///< With a beam during the sweep.
  std::int64_t missing_lines = 0;  ///< Between the first and the last of them, by number.
  std::int64_t missing_beams = 0;  ///< Of lines that are there in part.
  std::int64_t points = 0;
  std::int64_t no_return = 0;
  std::int64_t out_of_range = 0;  ///< Nearer or farther than the laser's limits.
  std::int64_t on_robot = 0;
  std::int64_t without_angle = 0;  ///< In a gap of the pan-tilt's messages.
  Steadiness steadiness;
};

struct AssembledSweep {
  Sweep sweep;  ///< In `base`, named sweep_<number>.
  AssemblyReport report;
};

/// Makes the sweep: each beam from where the laser was at the beam's own time (docs/conventions.md has the frames). A
/// robot that moves is not corrected for; the report says that it moved. The same for every number of threads.
AssembledSweep assemble(const AssemblyInput& input, const Robot& robot);

}  // namespace scanway
