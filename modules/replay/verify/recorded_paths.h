#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "common/grid/cost_map.h"
#include "common/robot/robot.h"
#include "modules/planner/node/plan_basis.h"
#include "modules/replay/verify/recorded_log.h"
#include "scanway/map_state_t.hpp"

namespace scanway {

/// The plans of a log that count (those that are not provisional). Each rests on a closed version of the map, a start
/// and a goal, all of which it names: it is planned again on exactly these.
class RecordedPaths {
 public:
  explicit RecordedPaths(const RecordedLog& log);

  /// Plans again what rests on `version`. Returns the first difference; empty: there is none.
  std::string compare(const Robot& robot, const CostMap& map, const ClosedVersion& version);
  /// After the last version: whether each start was a pose of the robot, and rests on a version that was derived.
  /// Returns the first difference; empty: there is none.
  std::string compare_starts(const std::vector<Start>& poses) const;
  /// Goals that are not in the log.
  const std::vector<std::string>& missing() const { return missing_; }
  /// Plans that are not whole, so that nobody knows what they rest on, and versions that nothing explains.
  const std::vector<std::string>& notes() const { return notes_; }
  std::size_t compared() const { return compared_; }
  std::size_t size() const { return paths_.size(); }

 private:
  struct Recorded {
    RecordedName name;
    path_t path;
    std::vector<Goal> goals;  // Of the log, at its place.
    Utime version_utime = 0;
    bool compared = false;
  };

  void note_versions();
  std::string difference(const Recorded& recorded, const Robot& robot, const CostMap& map,
                         const ClosedVersion& version) const;

  std::vector<Recorded> paths_;
  std::vector<std::string> missing_;
  std::vector<std::string> notes_;
  std::string fault_;
  std::size_t compared_ = 0;
};

}  // namespace scanway
