#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/geometry/pose.h"
#include "common/time/utime.h"

namespace scanway {

/// What became of one scan, for people and programs.
struct ScanReport {
  std::string name;
  Utime utime = 0;
  std::string target;  ///< What it was registered to; empty for the first.
  bool accepted = false;
  double probability = 0.0;
  double overlap = 0.0;
  double inlier_rmse_m = 0.0;
  std::string reason;
  Pose T_map_scan = Pose::Identity();
  std::optional<Pose> T_ref_scan;                       ///< If the log holds a reference.
  std::vector<std::pair<std::string, double>> seconds;  ///< By stage.
};

/// How a scan's pose differs from the reference's, both relative to the first accepted scan.
struct PoseError {
  double translation_m = 0.0;
  double rotation = 0.0;  ///< Radians.
};

/// What a PATH says of itself besides its poses.
struct PathReport {
  std::string status = "no goal";
  std::string unknown;
  bool map_up_to_date = false;
  double length_m = 0.0;
  double duration_s = 0.0;
  double clearance_m = 0.0;
  std::pair<double, double> clearance_at_m;
  double unknown_share = 0.0;
  double cost = 0.0;
  double worst_cost = 0.0;
  std::int64_t expansions = 0;
};

struct ReplayReport {
  std::string log;
  std::string trouble;  ///< What is wrong with the log, in one line; empty: nothing.
  std::vector<ScanReport> scans;
  std::map<std::string, std::string> digests;  ///< map, octomap, costmap, path: 16 hexadecimal digits each.
  std::map<std::string, std::int64_t> counters;
  PathReport path_without_embodiment;
  PathReport path_with_embodiment;
  std::vector<std::pair<std::string, double>> seconds;  ///< By stage, the whole run.
};

/// Nothing if scan or log have no reference, or the scan was refused.
std::optional<PoseError> pose_error(const ReplayReport& report, const ScanReport& scan);

/// report.json: docs/replay.md names the keys.
std::string report_json(const ReplayReport& report);

/// The table for people: scan, verdict, error against the reference, seconds a stage; then the two paths.
std::string report_table(const ReplayReport& report);

}  // namespace scanway
