#include "modules/replay/report.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/files/printable.h"
#include "common/math/repeatable.h"

namespace scanway {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const std::vector<std::pair<std::string, double>>& seconds) {
  Json json = Json::object();
  double total = 0.0;
  for (const auto& [stage, value] : seconds) {
    json[stage] = value;
    total += value;
  }
  json["total"] = total;
  return json;
}

Json to_json(const Pose& pose) {
  Json numbers = Json::array();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) numbers.push_back(pose.matrix()(row, column));
  }
  return numbers;
}

Json to_json(const PathReport& path) {
  return {{"status", path.status},
          {"unknown", path.unknown},
          {"map_up_to_date", path.map_up_to_date},
          {"length_m", path.length_m},
          {"duration_s", path.duration_s},
          {"clearance_m", path.clearance_m},
          {"clearance_at_m", {path.clearance_at_m.first, path.clearance_at_m.second}},
          {"unknown_share", path.unknown_share},
          {"cost", path.cost},
          {"worst_cost", path.worst_cost},
          {"expansions", path.expansions}};
}

double degrees(double angle) { return angle * 180.0 / repeatable::kPi; }

Json to_json(const ReplayReport& report, const ScanReport& scan) {
  Json json = {{"name", scan.name},
               {"target", scan.target},
               {"verdict", scan.accepted ? "accepted" : "refused"},
               {"probability", scan.probability},
               {"overlap", scan.overlap},
               {"inlier_rmse_m", scan.inlier_rmse_m},
               {"reason", scan.reason},
               {"T_map_scan", to_json(scan.T_map_scan)}};
  if (scan.T_ref_scan) json["T_ref_scan"] = to_json(*scan.T_ref_scan);
  if (const auto error = pose_error(report, scan)) {
    json["error_m"] = error->translation_m;
    json["error_deg"] = degrees(error->rotation);
  }
  json["seconds"] = to_json(scan.seconds);
  return json;
}

std::string path_line(const char* name, const PathReport& path) {
  if (path.status != "ok") return fmt::format("path {:<19} {}\n", name, printable(path.status));
  return fmt::format("path {:<19} {:.2f} m long, {:.2f} m clear, {:.0f} % unknown\n", name, path.length_m,
                     path.clearance_m, 100.0 * path.unknown_share);
}

/// Columns of the table, and the stages that each adds up; report.json has every stage by itself.
struct Column {
  const char* name;
  std::vector<const char*> stages;
};
const std::vector<Column>& columns() {
  static const std::vector<Column> kColumns = {
      {"features", {"prepare", "voxels", "surfaces", "neighbours", "normals", "fpfh"}},
      {"coarse", {"matching", "hypotheses", "checks"}},
      {"icp", {"icp", "verdict"}},
      {"graph", {"overlap", "movement", "graph"}},
      {"merge", {"merge", "remake"}},
      {"octomap", {"octomap"}},
      {"ground", {"ground"}},
      {"cost map", {"cost_map", "embodiment"}},
  };
  return kColumns;
}

std::string seconds_of(const ScanReport& scan, const Column& column) {
  double sum = 0.0;
  bool any = false;
  for (const auto& [stage, seconds] : scan.seconds) {
    if (std::find(column.stages.begin(), column.stages.end(), stage) == column.stages.end()) continue;
    sum += seconds;
    any = true;
  }
  return any ? fmt::format("{:.2f}", sum) : "-";
}

std::string scan_row(const ReplayReport& report, const ScanReport& scan) {
  std::string row = fmt::format("{:<12} {:<8} {:>5.2f}", printable(scan.name), scan.accepted ? "accepted" : "refused",
                                scan.probability);
  const auto error = pose_error(report, scan);
  row += error ? fmt::format(" {:>7.3f} {:>9.2f}", error->translation_m, degrees(error->rotation))
               : fmt::format(" {:>7} {:>9}", "-", "-");
  for (const Column& column : columns()) row += fmt::format(" {:>8}", seconds_of(scan, column));
  row += "\n";
  if (!scan.accepted) row += fmt::format("             {}\n", printable(scan.reason));
  return row;
}

}  // namespace

std::optional<PoseError> pose_error(const ReplayReport& report, const ScanReport& scan) {
  const auto first = std::find_if(report.scans.begin(), report.scans.end(), [](const auto& s) { return s.accepted; });
  if (first == report.scans.end() || !scan.accepted || !scan.T_ref_scan || !first->T_ref_scan) return std::nullopt;
  const Pose estimated = first->T_map_scan.inverse() * scan.T_map_scan;
  const Pose reference = first->T_ref_scan->inverse() * *scan.T_ref_scan;
  const Pose difference = reference.inverse() * estimated;
  return PoseError{difference.translation().norm(), rotation_angle(difference.linear())};
}

std::string report_json(const ReplayReport& report) {
  Json json;
  json["log"] = report.log;
  json["trouble"] = report.trouble;
  json["digests"] = report.digests;
  json["scans"] = Json::array();
  for (const ScanReport& scan : report.scans) json["scans"].push_back(to_json(report, scan));
  json["paths"] = {{"without_embodiment", to_json(report.path_without_embodiment)},
                   {"with_embodiment", to_json(report.path_with_embodiment)}};
  json["counters"] = report.counters;
  json["seconds"] = to_json(report.seconds);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_table(const ReplayReport& report) {
  std::string table = fmt::format("{:<27} {:>17}  seconds\n", "", "error");
  table += fmt::format("{:<12} {:<8} {:>5} {:>7} {:>9}", "scan", "verdict", "prob.", "m", "degrees");
  for (const Column& column : columns()) table += fmt::format(" {:>8}", column.name);
  table += "\n";
  for (const ScanReport& scan : report.scans) table += scan_row(report, scan);
  table += path_line("without embodiment:", report.path_without_embodiment);
  table += path_line("with embodiment:", report.path_with_embodiment);
  return table;
}

}  // namespace scanway
