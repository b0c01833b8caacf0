#include "modules/tools/plan/plan.h"

#include <cstdio>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/product_folder.h"
#include "common/grid/map_file.h"
#include "common/picture/pictures.h"
#include "common/progress/stage_timer.h"
#include "modules/mapper/core/costmap/embodiment.h"
#include "modules/planner/core/planner.h"
#include "modules/tools/plan/plan_answer.h"

namespace scanway::tools {
namespace {

using planning::BodyMode;
using planning::PathForm;
using planning::PlanResult;
using planning::PlanStatus;

BodyMode mode_of(const std::string& word) {
  if (word == "point") return BodyMode::point;
  if (word == "paper") return BodyMode::paper;
  if (word == "footprint") return BodyMode::footprint;
  throw InputError(fmt::format("--mode {}: must be point, paper or footprint", in_quotes(word)));
}

UnknownPolicy policy_of(const std::string& word) {
  if (word == "never") return UnknownPolicy::never;
  if (word == "price") return UnknownPolicy::price;
  if (word == "free") return UnknownPolicy::free;
  throw InputError(fmt::format("--unknown {}: must be never, price or free", in_quotes(word)));
}

Robot robot_of(const PlanOptions& options) {
  Robot robot = options.robot.empty() ? Robot() : load_robot(options.robot);
  robot.planning.unknown = policy_of(options.unknown);
  return robot;
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

/// The plan that was asked for, or another one beside it for comparison.
class Plan {
 public:
  Plan(BodyMode mode, const PicturedMap& map, const Robot& robot, const PlanOptions& options)
      : planner_(robot, mode, form_of(options)),
        start_(options.start_m.first, options.start_m.second),
        goal_(options.goal_m.first, options.goal_m.second) {
    planner_.set_map(map.map, map.extent);
  }

  PlanResult make(StageListener* stages = nullptr) { return planner_.plan(start_, goal_, stages); }
  planning::Explanation explain(const PlanResult& result) { return planner_.explain(result, start_, goal_); }

 private:
  static std::optional<PathForm> form_of(const PlanOptions& options) {
    if (!options.smooth) return std::nullopt;
    return *options.smooth ? PathForm::smooth : PathForm::cells;
  }

  planning::Planner planner_;
  Eigen::Vector2d start_, goal_;
};

std::vector<Eigen::Vector2d> points_of(const PlanResult& result) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& pose : result.path) points.emplace_back(pose.x_m, pose.y_m);
  return points;
}

/// path.csv and path.png.
void write_products(const ProductFolder& folder, const CostMap& map, const PlanOptions& options,
                    const PlanResult& result, const PlanResult& bare) {
  PathPicture picture{{options.start_m.first, options.start_m.second},
                      {options.goal_m.first, options.goal_m.second},
                      points_of(bare),
                      {}};
  if (options.mode != "point") picture.with_embodiment = points_of(result);
  draw_path(folder.path_of("path.png"), map, picture);
  folder.write("path.csv", csv_of(result));
}

/// All that a call of `scanway plan` found.
struct Answer {
  PlanResult result;
  PlanResult bare;  ///< The same for a point, for comparison.
  std::optional<planning::Explanation> why;
};

void print(const Answer& answer, const PlanOptions& options, StageTimer& timer) {
  if (!options.json) {
    fmt::print("{}: {}\n", options.mode, text_of(answer.result));
    if (options.mode != "point") fmt::print("point, for comparison: {}\n", text_of(answer.bare));
    if (answer.why) fmt::print("{}\n", answer.why->text);
    return;
  }
  nlohmann::ordered_json json = json_of(answer.result);
  if (answer.why) json["explanation"] = json_of(*answer.why);
  for (const auto& [stage, seconds] : timer.finish()) json["seconds"][stage] = seconds;
  json["seconds"]["total"] = timer.total_s();
  std::puts(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

}  // namespace

int run_plan(const PlanOptions& options) {
  const BodyMode mode = mode_of(options.mode);
  const Robot robot = robot_of(options);
  std::optional<ProductFolder> folder;
  if (!options.output.empty()) folder.emplace(options.output);
  StageTimer timer;
  timer.begin("read");
  PicturedMap map = read_pictured_map(options.map);
  timer.begin("costs");
  if (mode != BodyMode::point)
    embody(map.map, robot, mode == BodyMode::paper ? Embodiment::paper : Embodiment::footprint);
  timer.begin("prepare");
  Plan plan(mode, map, robot, options);
  Answer answer{plan.make(&timer), {}, {}};
  timer.begin("");
  if (!options.explain) refuse_bad_ends(answer.result, options);
  if (options.explain) timer.begin("explain");
  if (options.explain) answer.why = plan.explain(answer.result);
  answer.bare = answer.result;
  if (mode != BodyMode::point && (folder || !options.json)) {
    timer.begin("without_embodiment");
    answer.bare = Plan(BodyMode::point, map, robot, options).make();
  }
  if (folder) {
    timer.begin("draw");
    write_products(*folder, map.map, options, answer.result, answer.bare);
  }
  timer.finish();
  print(answer, options, timer);
  return 0;
}

}  // namespace scanway::tools
