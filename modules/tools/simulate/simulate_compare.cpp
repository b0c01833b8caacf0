#include "modules/tools/simulate/simulate_compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/product_folder.h"
#include "common/grid/bounds.h"
#include "common/math/angle.h"
#include "modules/tools/compare/cells/map_comparison.h"
#include "modules/tools/compare/replayed_folder.h"
#include "modules/tools/simulate/simulated_world.h"

namespace scanway::tools {
namespace {

using namespace scanway::simulator;
using Json = nlohmann::ordered_json;

double degrees(double angle) { return angle / radians(1); }
double percent(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// How a sweep lies to another one, against how it lay in truth.
struct PoseError {
  double m = 0.0, deg = 0.0;
};
PoseError error_between(const PlacedSweep& from, const PlacedSweep& to) {
  const Pose placed = from.T_map_scan.inverse() * to.T_map_scan, truth = from.T_ref_scan.inverse() * to.T_ref_scan;
  const Pose error = truth.inverse() * placed;
  return {error.translation().norm(), degrees(rotation_angle(error.linear()))};
}

struct SweepErrors {
  const PlacedSweep* sweep = nullptr;
  std::optional<PoseError> to_first, to_previous;  ///< Of an accepted sweep, to accepted ones.
};

std::vector<SweepErrors> errors_of(const std::vector<PlacedSweep>& sweeps) {
  std::vector<SweepErrors> errors;
  const PlacedSweep *first = nullptr, *previous = nullptr;
  for (const PlacedSweep& sweep : sweeps) {
    SweepErrors one{&sweep, std::nullopt, std::nullopt};
    if (sweep.accepted) {
      if (first == nullptr) first = &sweep;
      one.to_first = error_between(*first, sweep);
      one.to_previous = error_between(previous == nullptr ? sweep : *previous, sweep);
      previous = &sweep;
    }
    errors.push_back(one);
  }
  return errors;
}

/// The part of the world that the map covers.
Rectangle covered(const CostMap& map, const Pose& X_world_map, const World& world) {
  const auto cells = bounds(map);
  if (!cells) throw InputError("the cost map knows no cell: there is nothing to compare");
  Rectangle part{world.extent.high, world.extent.low};
  for (const double x : {cells->low.x * map.resolution_m, cells->high.x * map.resolution_m}) {
    for (const double y : {cells->low.y * map.resolution_m, cells->high.y * map.resolution_m}) {
      const Eigen::Vector3d corner = X_world_map * Eigen::Vector3d(map.origin_x_m + x, map.origin_y_m + y, 0.0);
      part.low = part.low.cwiseMin(corner.head<2>());
      part.high = part.high.cwiseMax(corner.head<2>());
    }
  }
  return {part.low.cwiseMax(world.extent.low), part.high.cwiseMin(world.extent.high)};
}

MapComparison compare_maps(const ReplayedFolder& replayed, const World& world) {
  std::vector<TrueSweep> accepted;
  std::optional<Pose> X_map_world;
  for (const PlacedSweep& placed : replayed.sweeps) {
    if (!placed.accepted) continue;
    accepted.push_back({&placed.sweep, placed.T_ref_scan});
    if (!X_map_world) X_map_world = placed.T_map_scan * placed.T_ref_scan.inverse();
  }
  if (!X_map_world) throw InputError("no sweep was accepted: there is no map to compare");
  const Rectangle part = covered(replayed.cost_map, X_map_world->inverse(), world);
  const TruthGrid truth = make_truth(world, replayed.robot.body, replayed.cost_map.resolution_m, part);
  const CellWindow window{truth.resolution_m, truth.low.x, truth.low.y, truth.low.x + truth.width,
                          truth.low.y + truth.height};
  return compare(replayed.cost_map, *X_map_world, truth, seen_ground(world, replayed.robot, accepted, window));
}

Json to_json(const CellCounts& cells) {
  return {{"free", cells.free},
          {"free_called_occupied", cells.free_called_occupied},
          {"free_called_unknown", cells.free_called_unknown},
          {"free_lost_percent", percent(cells.free_lost(), cells.free)},
          {"occupied", cells.occupied},
          {"occupied_called_free", cells.occupied_called_free},
          {"occupied_unmarked", cells.occupied_unmarked},
          {"occupied_missed_percent", percent(cells.occupied_called_free, cells.occupied)}};
}

Json to_json(const SweepErrors& errors) {
  Json json = {{"name", errors.sweep->name},
               {"verdict", errors.sweep->accepted ? "accepted" : "refused"},
               {"probability", errors.sweep->probability}};
  if (!errors.to_first) return json;
  json["error_m"] = errors.to_first->m;
  json["error_deg"] = errors.to_first->deg;
  json["to_previous_error_m"] = errors.to_previous->m;
  json["to_previous_error_deg"] = errors.to_previous->deg;
  return json;
}

std::string json_of(const std::vector<SweepErrors>& errors, const MapComparison& map) {
  Json json;
  json["sweeps"] = Json::array();
  for (const SweepErrors& one : errors) json["sweeps"].push_back(to_json(one));
  json["cost_map"] = {{"seen_once", to_json(map.one)}, {"seen_twice_or_more", to_json(map.two)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string row(const SweepErrors& errors) {
  std::string row = fmt::format("{:<12} {:<8} {:>5.2f}", printable(errors.sweep->name),
                                errors.sweep->accepted ? "accepted" : "refused", errors.sweep->probability);
  for (const auto& error : {errors.to_first, errors.to_previous}) {
    row += error ? fmt::format(" {:>9.4f} {:>8.3f}", error->m, error->deg) : fmt::format(" {:>9} {:>8}", "-", "-");
  }
  return row + "\n";
}

std::string row(const char* name, const CellCounts& cells) {
  return fmt::format("{:<16} {:>9} {:>9} {:>7.3f} {:>9} {:>9} {:>7.3f} {:>9}\n", name, cells.free, cells.free_lost(),
                     percent(cells.free_lost(), cells.free), cells.occupied, cells.occupied_called_free,
                     percent(cells.occupied_called_free, cells.occupied), cells.occupied_unmarked);
}

std::string table_of(const std::vector<SweepErrors>& errors, const MapComparison& map) {
  std::string table = fmt::format("{:<27} {:>18} {:>18}\n", "", "to the first:", "to the one before:");
  table += fmt::format("{:<12} {:<8} {:>5} {:>9} {:>8} {:>9} {:>8}\n", "sweep", "verdict", "prob.", "m", "degrees", "m",
                       "degrees");
  for (const SweepErrors& one : errors) table += row(one);
  table += fmt::format("\n{:<16} {:>9} {:>9} {:>7} {:>9} {:>9} {:>7} {:>9}\n", "ground seen by", "free", "lost", "%",
                       "occupied", "missed", "%", "unmarked");
  return table + row("one sweep", map.one) + row("two or more", map.two);
}

}  // namespace

int run_simulate_compare(const SimulateCompareOptions& options) {
  const World world = world_of(options.world, options.seed);
  const ReplayedFolder replayed = read_replayed(options.folder);
  const std::vector<SweepErrors> errors = errors_of(replayed.sweeps);
  const MapComparison map = compare_maps(replayed, world);
  const std::string json = json_of(errors, map);
  ProductFolder(options.folder).write("truth.json", json);
  std::fputs((options.json ? json : table_of(errors, map)).c_str(), stdout);
  return 0;
}

}  // namespace scanway::tools
