// First plans, replans and a planner's life against a textbook A* and planning anew, one thread, CPU time.
//
//   planning_bench [RUNS] [SIDE]     corner to corner: first plans, and replans after a change near the robot
//   planning_bench life [EVERY]      4000 x 4000: a driving robot, a moving goal, a change near the goal; every
//                                    EVERY-th problem is planned anew too
//   planning_bench smooth [SIDE]     what straightening, rounding and timing a path takes, and what it gains
//   planning_bench large             10,000 x 10,000 rubble: time and memory

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <vector>

#include "modules/planner/core/planner.h"
#include "tests/bench/planning/cpu_time.h"
#include "tests/bench/planning/lives.h"
#include "tests/bench/planning/scenes.h"
#include "tests/bench/planning/textbook.h"

namespace scanway::bench {
namespace {

using planning::Planner;
using planning::PlanResult;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

PlanResult plan_across(Planner& planner, const Scene& scene) {
  return planner.plan({0.5, 0.5}, {scene.side - 0.5, scene.side - 0.5});
}

struct Row {
  std::vector<double> textbook_ms, first_ms, replan_ms;
  PlainAnswer textbook;
  PlanResult first, replan;
  double replan_textbook_cost = 0.0;
};

Row measure(const Scene& original, int runs) {
  Row row;
  for (int run = 0; run < runs; ++run) {
    Scene scene = original;
    const PlainMap map = plain(scene);
    row.textbook_ms.push_back(cpu_ms([&] { row.textbook = textbook_a_star(map); }));
    Planner planner(Robot(), scene.mode);
    planner.set_map(scene.map, CellRectangle{{0, 0}, {scene.side, scene.side}});
    row.first_ms.push_back(cpu_ms([&] { row.first = plan_across(planner, scene); }));
    const std::vector<Cell> tiles = scatter(scene, {20, 20}, {220, 220});
    row.replan_ms.push_back(cpu_ms([&] {
      planner.update(scene.map, tiles);
      row.replan = plan_across(planner, scene);
    }));
    if (run == 0) row.replan_textbook_cost = textbook_a_star(plain(scene)).cost;
  }
  return row;
}

void print(const char* name, const Row& row) {
  const double textbook = median(row.textbook_ms), first = median(row.first_ms), replan = median(row.replan_ms);
  std::printf("| %s | %.0f | %.0f | %.1f | %.1f | %.0f | %llu | %llu | %llu |\n", name, textbook, first,
              textbook / first, replan, first / replan, static_cast<unsigned long long>(row.textbook.expansions),
              static_cast<unsigned long long>(row.first.effort.expansions),
              static_cast<unsigned long long>(row.replan.effort.expansions + row.replan.effort.dropped));
  if (std::fabs(row.first.cost - row.textbook.cost) > 0.01 ||
      std::fabs(row.replan.cost - row.replan_textbook_cost) > 0.01) {
    std::printf("the costs differ: %.3f and %.3f, replanned %.3f and %.3f\n", row.first.cost, row.textbook.cost,
                row.replan.cost, row.replan_textbook_cost);
  }
  std::fflush(stdout);
}

void first_plans(int runs, int side) {
  std::printf("%d x %d cells, corner to corner, CPU ms, medians of %d\n", side, side, runs);
  std::printf(
      "| map | textbook A* | first plan | times faster | replan | times faster than first | expanded by A* | by "
      "the first plan | by the replan, with dropped |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& make : {rubble, rooms, weighted}) {
    const Scene scene = make(side);
    print(scene.name, measure(scene, runs));
  }
}

void print(const char* scene, const char* what, const Life& life) {
  std::printf("| %s | %s | %d | %.0f | %.0f | %.3f | %d |\n", scene, what, life.plans, life.kept_ms, life.anew_ms,
              life.kept_ms / life.anew_ms, life.differ);
  std::fflush(stdout);
}

void lives(int every) {
  std::printf("4000 x 4000 cells, CPU ms; planning anew at every %dth problem, times %d\n", every, every);
  std::printf("| map | what | plans | kept | anew | kept / anew | other cost |\n|---|---|---|---|---|---|---|\n");
  for (const auto& make : {rubble, rooms, weighted}) {
    const Scene scene = make(4000);
    print(scene.name, "change near the goal", change_near_goal(scene));
    print(scene.name, "driving robot", drive(scene, every));
    print(scene.name, "moving goal", follow(scene, every));
  }
}

/// For the body in scenes where it has room, the others for a point.
void smooth(const Scene& scene, planning::BodyMode mode) {
  const auto plan = [&](planning::PathForm form, CpuStages& stages) {
    Planner planner(Robot(), mode, form);
    planner.set_map(scene.map, CellRectangle{{0, 0}, {scene.side, scene.side}});
    const double from = 0.5 * scene.map.resolution_m + 0.3, to = scene.side * scene.map.resolution_m - from;
    return planner.plan({from, from}, {to, to}, &stages);
  };
  CpuStages of_cells, of_smooth;
  const PlanResult cells = plan(planning::PathForm::cells, of_cells);
  const PlanResult line = plan(planning::PathForm::smooth, of_smooth);
  if (line.path.empty()) return static_cast<void>(std::printf("| %s | %s |\n", scene.name, line.reason.c_str()));
  std::printf("| %s, %s | %.1f | %.2f | %.2f | %.1f | %.1f | %.2f | %.2f | %.1f | %.1f |\n", scene.name,
              mode == planning::BodyMode::footprint ? "body" : "point", of_smooth.of("search"), of_smooth.of("smooth"),
              of_smooth.of("measure"), cells.length_m, line.length_m, cells.clearance_m, line.clearance_m,
              cells.path.back().time_s, line.path.back().time_s);
  std::fflush(stdout);
}

void smooth_paths(int side) {
  std::printf(
      "%d x %d cells, corner to corner, CPU ms, path from cell to cell -> smooth\n| map | search | smooth | measure | "
      "length, m | smooth | clearance, m | smooth | seconds to drive | smooth "
      "|\n|---|---|---|---|---|---|---|---|---|---|\n",
      side, side);
  smooth(rubble(side), planning::BodyMode::point);
  smooth(rooms(side), planning::BodyMode::point);
  smooth(weighted(side), planning::BodyMode::paper);
  Scene fine = rooms(side);
  fine.map.resolution_m = 0.2;
  smooth(fine, planning::BodyMode::footprint);
}

/// Bytes of memory that this process has.
double resident() {
  std::ifstream file("/proc/self/statm");
  double all = 0.0, pages = 0.0;
  file >> all >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

void large() {
  const Scene scene = rubble(10000);
  const double before = resident();
  Planner planner(Robot(), scene.mode);
  const double map_ms = cpu_ms([&] { planner.set_map(scene.map, CellRectangle{{0, 0}, {scene.side, scene.side}}); });
  PlanResult plan;
  const double plan_ms = cpu_ms([&] { plan = plan_across(planner, scene); });
  std::printf("10,000 x 10,000 rubble: map %.0f ms, plan %.0f ms, %llu expansions, %.2f bytes a cell\n", map_ms,
              plan_ms, static_cast<unsigned long long>(plan.effort.expansions), (resident() - before) / 1e8);
}

}  // namespace
}  // namespace scanway::bench

int main(int argc, char** argv) {
  using namespace scanway::bench;
  const auto number = [&](int at, int otherwise) { return argc > at ? std::atoi(argv[at]) : otherwise; };
  if (argc > 1 && std::strcmp(argv[1], "life") == 0) {
    lives(std::max(1, number(2, 10)));
  } else if (argc > 1 && std::strcmp(argv[1], "smooth") == 0) {
    smooth_paths(number(2, 4000));
  } else if (argc > 1 && std::strcmp(argv[1], "large") == 0) {
    large();
  } else {
    first_plans(number(1, 5), number(2, 4000));
  }
}
