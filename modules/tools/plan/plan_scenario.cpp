#include "modules/tools/plan/plan_scenario.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/files/printable.h"
#include "common/progress/stage_timer.h"
#include "modules/planner/core/planner.h"
#include "modules/tools/output/progress_bar.h"
#include "modules/tools/plan/moving_ai.h"

namespace scanway::tools {
namespace {

using planning::PlanResult;
using planning::PlanStatus;

constexpr double kAsLong = 0.01;  ///< Older files were made with a rounded sqrt(2).

struct Tally {
  std::size_t optimal = 0;
  std::size_t unsolved = 0;
  double worst_error = 0.0;  ///< Of those that were solved.
  std::size_t worst = 0;     ///< Which problem that was.
};

Eigen::Vector2d middle_of(Cell cell) { return {cell.x + 0.5, cell.y + 0.5}; }

void count(const PlanResult& result, const ScenarioProblem& problem, std::size_t number, Tally& tally) {
  if (result.status != PlanStatus::ok) {
    ++tally.unsolved;
    return;
  }
  const double error = std::fabs(result.length_m - problem.optimal_length);
  if (error <= kAsLong) ++tally.optimal;
  if (error <= tally.worst_error) return;
  tally.worst_error = error;
  tally.worst = number;
}

Tally solve_all(const Scenario& scenario) {
  planning::Planner planner(Robot(), planning::BodyMode::point);
  planner.set_map(scenario.map, scenario.bounds);
  ProgressBar bar("planning");
  Tally tally;
  for (std::size_t i = 0; i < scenario.problems.size(); ++i) {
    const ScenarioProblem& problem = scenario.problems[i];
    count(planner.plan(middle_of(problem.start), middle_of(problem.goal)), problem, i + 1, tally);
    bar.show(static_cast<double>(i + 1) / static_cast<double>(scenario.problems.size()));
  }
  return tally;
}

}  // namespace

int run_plan_scenario(const PlanScenarioOptions& options) {
  StageTimer timer;
  timer.begin("read");
  const Scenario scenario = read_scenario(options.scenario);
  timer.begin("plan");
  const Tally tally = solve_all(scenario);
  const auto seconds = timer.finish();
  if (options.json) {
    nlohmann::ordered_json json = {{"problems", scenario.problems.size()},
                                   {"optimal", tally.optimal},
                                   {"unsolved", tally.unsolved},
                                   {"worst_error", tally.worst_error},
                                   {"seconds", timer.total_s()}};
    std::puts(json.dump(2).c_str());
  } else {
    fmt::print("{}: {} of {} problems optimal to {}, worst error {:.4f}{}, {} without a path, {:.2f} s\n",
               printable(options.scenario), tally.optimal, scenario.problems.size(), kAsLong, tally.worst_error,
               tally.worst == 0 ? "" : fmt::format(" (problem {})", tally.worst), tally.unsolved, timer.total_s());
  }
  return tally.optimal == scenario.problems.size() ? 0 : 1;
}

}  // namespace scanway::tools
