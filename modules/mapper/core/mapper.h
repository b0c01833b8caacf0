#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/cloud/sweep.h"
#include "common/geometry/pose.h"
#include "common/progress/stages.h"
#include "common/robot/robot.h"
#include "common/time/utime.h"
#include "modules/mapper/core/locate.h"
#include "modules/mapper/core/map.h"
#include "modules/mapper/core/movement/movement.h"
#include "modules/mapper/core/registration/registration.h"
#include "modules/mapper/core/sweep_graph.h"

namespace scanway {

/// Where an accepted sweep was taken.
struct TrajectoryPoint {
  Utime utime = 0;
  Pose X_map_sweep = Pose::Identity();
  bool withdrawn = false;  ///< Its sweep is in no product any more.
};

/// How far poses may move before the products follow: a cell of the cost map, or as much at 10 m.
struct ToleratedMove {
  double shift_m = 0.01;
  double turn = 0.001;  ///< Radians.
};

/// That a new sweep moved the earlier ones so far that the map was made again.
struct MapCorrection {
  std::size_t remade = 0;  ///< Sweeps that the map was made of again; 0: none had to move.
  double shift_m = 0.0;    ///< Of the sweep that moved most.
  double turn = 0.0;       ///< Radians, of the sweep that turned most.
};

/// What became of one sweep.
struct SweepResult {
  std::string name;
  Utime utime = 0;
  Verdict verdict = Verdict::refused;
  std::string reason;                   ///< One sentence for people.
  std::string target;                   ///< Name of the sweep it was registered against; empty for the first.
  RegistrationResult registration;      ///< Against `target`; of the first sweep: the identity, with probability 1.
  Pose X_map_sweep = Pose::Identity();  ///< Of an accepted sweep.
  MapChange change;                     ///< Of an accepted sweep; else the version that stayed.
  MapCorrection correction;             ///< Of the sweeps before it.
  Movement movement;                    ///< While it was taken, as far as it is known.
};

/// What became of the wish to withdraw a sweep.
struct Withdrawal {
  bool done = false;
  std::string reason;  ///< Why it was not; one sentence for people.
  MapChange change;    ///< If it was not: the version that stayed.
};

/// The mapper: sweeps in, in the order of their time, a map out. A refused sweep changes no product.
class Mapper {
 public:
  explicit Mapper(const Robot& robot, std::uint64_t seed = 1, const ToleratedMove& tolerated = {},
                  MapStorage storage = {});

  /// The whole method: prepare, register against the sweeps that overlap it, settle the poses of all, and merge into
  /// every product; where earlier sweeps moved by more than is tolerated, the products follow.
  /// Stages: those of the registration, overlap, movement, graph, merge, octomap, ground, cost_map, embodiment; where
  /// products follow poses: remake.
  SweepResult add(const Sweep& sweep, StageListener* stages = nullptr);

  /// Takes the newest sweep of that name out of every product, as if it had never been there; the poses of the others
  /// stay. Nothing is registered to it any more, and from the next sweep on it holds no pose (see SweepGraph).
  Withdrawal withdraw(const std::string& name, StageListener* stages = nullptr);

  /// The map goes on with sweeps of another session, after the robot was moved or its tracker started again: the first
  /// of them is searched in the whole map. Versions are counted anew; what stands is the first.
  void begin_session();

  const Map& map() const { return map_; }
  const SweepGraph& graph() const { return graph_; }
  /// The poses at which the products hold the sweeps.
  const std::vector<TrajectoryPoint>& trajectory() const { return trajectory_; }
  const std::vector<SweepResult>& results() const { return results_; }  ///< One a sweep, accepted or not.

 private:
  SweepResult place(const Sweep& sweep, StageListener* stages);
  SweepResult place_first(const Sweep& sweep, PlacedSweep placed);
  SweepResult place_among(const Sweep& sweep, PlacedSweep placed, StageListener* stages);
  MapCorrection correction() const;
  std::vector<SweepMove> follow_poses();

  Robot robot_;
  ToleratedMove tolerated_;
  RegistrationConfig registration_;
  Locator locator_;
  Map map_;
  SweepGraph graph_;
  std::vector<TrajectoryPoint> trajectory_;
  std::vector<SweepResult> results_;
  int session_ = 0;
};

}  // namespace scanway
