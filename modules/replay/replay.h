#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/log_reader.h"
#include "common/progress/stage_timer.h"
#include "common/robot/robot.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/mapper/node/sweep_assembler.h"
#include "modules/planner/node/planner_node.h"
#include "modules/replay/replay_bus.h"
#include "modules/replay/report.h"
#include "scanway/map_answer_t.hpp"
#include "scanway/registration_t.hpp"

namespace scanway {

/// Sweeps that an assembler made, by key and version of their objects.
using AssembledSweeps = std::set<std::pair<std::string, std::int64_t>>;

/// What a log says of how it came about.
struct LogStory {
  std::optional<Robot> robot;         ///< The mapper's first PARAMS, or else the log's first; nothing if there is none.
  ListedOrientations orientations;    ///< By SWEEP_INPUTS.
  std::vector<map_answer_t> answers;  ///< What became of commands to the map.
  AssembledSweeps assembled;          ///< Whose lines and marks the log holds: they are made of these again.
};

/// Throws InputError for a configuration that cannot be read.
LogStory story_of_log(const std::string& path);

/// The nodes in one process over a log. What is derived in the log is left aside and made anew.
class Replay {
 public:
  /// `recording` gets the log's inputs, `robot` as the PARAMS in force, and all that the nodes publish; it must outlive
  /// this. A sweep of `story.orientations` gets the orientation that it had when it was recorded; one of
  /// `story.assembled` is made of its lines, and what the log holds of it on SWEEP is left aside.
  Replay(const Robot& robot, LogWriter& recording, LogStory story = {});

  /// The log goes on with the map of another session. Before run().
  void resume(SweepStore map) { continued_ = std::move(map); }
  /// The log goes on where the map of `store` ended, in the same session, and its sweeps are kept there too. `store`
  /// must outlive this. Before run().
  void go_on_with(const SweepStore& store) { gone_on_with_ = &store; }
  /// Keeps the sweeps of the map in `store`, which is empty and must outlive this. Before run().
  void keep_in(const SweepStore& store) { mapper_.keep_in(store); }
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

  bool is_left_aside(const LogEvent& event) const;
  void begin(Utime utime);
  void note_scan(const BusMessage& verdict);
  void note_last_poses(std::vector<ScanReport>& scans) const;
  void note_reference(const BusMessage& reference);
  std::optional<Pose> reference_of(const ScanReport& scan) const;
  std::map<std::string, std::int64_t> counters() const;

  const Robot robot_;
  ReplayBus bus_;
  StageTimer run_timer_;
  ScanTimer scan_timer_;
  const AssembledSweeps assembled_;
  std::optional<SweepStore> continued_;
  const SweepStore* gone_on_with_ = nullptr;
  MapperNode mapper_;
  SweepAssembler assembler_;
  PlannerNode planner_;
  std::vector<ScanReport> scans_;
  std::map<std::string, Pose> references_;
  std::map<Utime, Pose> truth_;  // Of the simulated robot.
};

}  // namespace scanway
