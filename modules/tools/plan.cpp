#include "modules/tools/plan.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/config/robot_file.h"
#include "common/config/yaml_document.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/product_folder.h"
#include "common/files/read_file.h"
#include "common/grid/map_file.h"
#include "common/grid/pgm.h"
#include "common/picture/pictures.h"
#include "common/progress/stage_timer.h"
#include "modules/mapper/core/costmap/embodiment.h"
#include "modules/planner/core/planner.h"

namespace scanway::tools {
namespace {

using planning::BodyMode;
using planning::PlanResult;
using planning::PlanStatus;

BodyMode mode_of(const std::string& word) {
  if (word == "point") return BodyMode::point;
  if (word == "paper") return BodyMode::paper;
  if (word == "footprint") return BodyMode::footprint;
  throw InputError(fmt::format("--mode {}: must be point, paper or footprint", scanway::quoted(word)));
}

UnknownPolicy policy_of(const std::string& word) {
  if (word == "never") return UnknownPolicy::never;
  if (word == "price") return UnknownPolicy::price;
  if (word == "free") return UnknownPolicy::free;
  throw InputError(fmt::format("--unknown {}: must be never, price or free", scanway::quoted(word)));
}

Robot robot_of(const PlanOptions& options) {
  Robot robot = options.robot.empty() ? Robot() : load_robot(options.robot);
  robot.planning.unknown = policy_of(options.unknown);
  return robot;
}

/// The cells that the picture of a map covers, its unknown rim too.
CellRectangle picture_of(const std::string& yaml) {
  const std::string image = yaml_mapping(read_file(yaml), yaml)["image"].Scalar();
  const std::string path = (std::filesystem::path(yaml).parent_path() / image).string();
  const GreyPicture picture = picture_from_pgm(read_file(path), path);
  return {{0, 0}, {picture.width, picture.height}};
}

/// A start or goal that cannot be one at all is a mistake of the caller's, not an answer about the map.
void refuse_bad_ends(const PlanResult& result, const PlanOptions& options) {
  const auto fail = [&](const char* flag, const std::pair<double, double>& point, const char* what) {
    throw InputError(fmt::format("{}: {} {},{} is {}; choose another point", printable(options.map), flag, point.first,
                                 point.second, what));
  };
  if (result.status == PlanStatus::no_map) throw InputError(printable(options.map) + ": the map has no known cell");
  if (result.status == PlanStatus::start_off_map) fail("--start", options.start_m, "off the map");
  if (result.status == PlanStatus::goal_off_map) fail("--goal", options.goal_m, "off the map");
  if (result.status == PlanStatus::start_in_obstacle) fail("--start", options.start_m, "in an obstacle");
  if (result.status == PlanStatus::goal_in_obstacle) fail("--goal", options.goal_m, "in an obstacle");
}

/// One plan on the map, in a mode.
PlanResult plan_as(BodyMode mode, const CostMap& map, const CellRectangle& bounds, const Robot& robot,
                   const PlanOptions& options, StageTimer& timer) {
  const bool whole = mode == mode_of(options.mode);
  timer.begin(whole ? "prepare" : "without_embodiment");
  planning::Planner planner(robot, mode);
  planner.set_map(map, bounds);
  if (whole) timer.begin("plan");
  return planner.plan({options.start_m.first, options.start_m.second}, {options.goal_m.first, options.goal_m.second});
}

nlohmann::ordered_json json_of(const PlanResult& result, StageTimer& timer) {
  nlohmann::ordered_json json;
  json["status"] = result.reason;
  json["length_m"] = result.length_m;
  // JSON has no infinity: null says that there is no obstacle to be near to.
  json["clearance_m"] = std::isfinite(result.clearance_m) ? nlohmann::ordered_json(result.clearance_m) : nullptr;
  json["unknown_share"] = result.unknown_share;
  json["cost"] = result.cost;
  json["path"] = nlohmann::ordered_json::array();
  for (const auto& pose : result.path) json["path"].push_back({pose.x_m, pose.y_m, pose.heading});
  json["expansions"] = result.effort.expansions;
  for (const auto& [stage, seconds] : timer.finish()) json["seconds"][stage] = seconds;
  json["seconds"]["total"] = timer.total_s();
  return json;
}

std::string text_of(const PlanResult& result) {
  if (result.status != PlanStatus::ok) return "no path: " + result.reason;
  const std::string clearance = std::isfinite(result.clearance_m)
                                    ? fmt::format("clearance {:.3f} m at ({:.2f}, {:.2f})", result.clearance_m,
                                                  result.clearance_at_m.x(), result.clearance_at_m.y())
                                    : "no obstacle anywhere";
  return fmt::format("length {:.3f} m, cost {:.3f}, {}, {:.1f} % unknown, {} expansions", result.length_m, result.cost,
                     clearance, 100.0 * result.unknown_share, result.effort.expansions);
}

std::string csv_of(const PlanResult& result) {
  std::string csv = "x_m,y_m,heading_rad\n";
  for (const auto& pose : result.path) csv += fmt::format("{},{},{}\n", pose.x_m, pose.y_m, pose.heading);
  return csv;
}

std::vector<Eigen::Vector2d> points_of(const PlanResult& result) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& pose : result.path) points.emplace_back(pose.x_m, pose.y_m);
  return points;
}

}  // namespace

int run_plan(const PlanOptions& options) {
  const BodyMode mode = mode_of(options.mode);
  const Robot robot = robot_of(options);
  std::optional<ProductFolder> folder;
  if (!options.output.empty()) folder.emplace(options.output);
  StageTimer timer;
  timer.begin("read");
  CostMap map = read_map(options.map);
  const CellRectangle bounds = picture_of(options.map);
  timer.begin("costs");
  if (mode != BodyMode::point) embody(map, robot, mode == BodyMode::paper ? Embodiment::paper : Embodiment::footprint);
  const PlanResult result = plan_as(mode, map, bounds, robot, options, timer);
  refuse_bad_ends(result, options);
  PlanResult bare = result;
  if (mode != BodyMode::point && (folder || !options.json)) {
    bare = plan_as(BodyMode::point, map, bounds, robot, options, timer);
  }
  if (folder) {
    timer.begin("draw");
    PathPicture picture{{options.start_m.first, options.start_m.second},
                        {options.goal_m.first, options.goal_m.second},
                        points_of(bare),
                        {}};
    if (mode != BodyMode::point) picture.with_embodiment = points_of(result);
    draw_path(folder->path_of("path.png"), map, picture);
    folder->write("path.csv", csv_of(result));
  }
  timer.finish();
  if (options.json) {
    std::puts(json_of(result, timer).dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return 0;
  }
  fmt::print("{}: {}\n", options.mode, text_of(result));
  if (mode != BodyMode::point) fmt::print("point, for comparison: {}\n", text_of(bare));
  return 0;
}

}  // namespace scanway::tools
