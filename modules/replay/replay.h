#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/log_reader.h"
#include "common/progress/stage_timer.h"
#include "common/robot/robot.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/planner/node/planner_node.h"
#include "modules/replay/replay_bus.h"
#include "modules/replay/report.h"
#include "scanway/registration_t.hpp"

namespace scanway {

/// The robot that a log was recorded with (its first PARAMS), or nothing. Throws InputError for a configuration that
/// cannot be read.
std::optional<Robot> robot_of_log(const std::string& path);

/// The nodes in one process over a log. What is derived in the log is left aside and made anew.
class Replay {
 public:
  /// `recording` gets the log's inputs and all that the nodes publish; it must outlive this.
  Replay(const Robot& robot, LogWriter& recording);

  /// Feeds the whole log. `progress` is told how far it is, from 0 to 1, now and then.
  void run(LogReader& log, const std::function<void(double)>& progress = {});

  const MapperNode& mapper() const { return mapper_; }
  const PlannerNode& planner() const { return planner_; }
  /// Scans, paths, counters and seconds; digests of the map's files are for whoever writes them.
  ReplayReport report();

 private:
  /// The mapper's stages, for the whole run and for the scan under way.
  class ScanTimer : public StageListener {
   public:
    explicit ScanTimer(StageTimer& run) : run_(run) {}
    void begin(std::string_view name) override;
    /// The seconds of the scan that ends now.
    std::vector<std::pair<std::string, double>> finish_scan();

   private:
    StageTimer& run_;
    StageTimer scan_;
  };

  void note_scan(const BusMessage& verdict);
  void note_reference(const BusMessage& reference);
  std::map<std::string, std::int64_t> counters() const;

  ReplayBus bus_;
  StageTimer run_timer_;
  ScanTimer scan_timer_;
  MapperNode mapper_;
  PlannerNode planner_;
  std::vector<ScanReport> scans_;
  std::map<std::string, Pose> references_;
};

}  // namespace scanway
