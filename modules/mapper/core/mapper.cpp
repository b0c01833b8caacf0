#include "modules/mapper/core/mapper.h"

#include <algorithm>
#include <utility>

#include "modules/mapper/core/placement_reason.h"
#include "modules/mapper/core/sweep_movement.h"

namespace scanway {
namespace {

constexpr std::size_t kMinPoints = 1000;  // fewer show no place that could be found again

std::size_t usable_points(const Sweep& sweep, const Robot& robot) {
  return points_in_map(sweep, Pose::Identity(), robot.laser.min_range_m, robot.laser.max_range_m).points.size();
}

/// The link that is most probably right, of those that the graph kept.
const Link& best_of(const std::vector<Link>& links, const GraphSolution& solution) {
  const std::size_t before = solution.dropped.size() - links.size();
  const Link* best = nullptr;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (solution.dropped[before + i]) continue;
    if (best == nullptr || links[i].registration.probability > best->registration.probability) best = &links[i];
  }
  return *best;
}

void report_against(const std::string& target, const RegistrationResult& registration, SweepResult& result) {
  result.target = target;
  result.registration = registration;
}

}  // namespace

Mapper::Mapper(const Robot& robot, std::uint64_t seed, const ToleratedMove& tolerated, MapStorage storage)
    : robot_(robot),
      tolerated_(tolerated),
      registration_{robot.laser.min_range_m, robot.laser.max_range_m, seed},
      locator_(robot, registration_),
      map_(robot, seed, std::move(storage)),
      graph_(robot) {}

void Mapper::begin_session() {
  ++session_;
  if (map_.version() > 0) map_.restart_versions();
}

SweepResult Mapper::add(const Sweep& sweep, StageListener* stages) {
  SweepResult result = place(sweep, stages);
  result.name = sweep.name;
  result.utime = sweep.utime;
  result.change.version = map_.version();
  if (result.verdict == Verdict::accepted) {
    result.correction = correction();
    const std::vector<SweepMove> moves = result.correction.remade > 0 ? follow_poses() : std::vector<SweepMove>();
    trajectory_.push_back({sweep.utime, result.X_map_sweep});
    result.change = map_.merge(sweep, result.X_map_sweep, stages, moves);
    result.reason += said_of(result.change.ground);
  }
  begin_stage(stages, "");
  results_.push_back(result);
  return result;
}

Withdrawal Mapper::withdraw(const std::string& name, StageListener* stages) {
  Withdrawal withdrawal;
  withdrawal.change.version = map_.version();
  for (std::size_t i = trajectory_.size(); i-- > 0;) {
    if (trajectory_[i].withdrawn || graph_.sweeps()[i].name != name) continue;
    trajectory_[i].withdrawn = withdrawal.done = true;
    graph_.withdraw(i);
    withdrawal.change = map_.withdraw(i, stages);
    return withdrawal;
  }
  withdrawal.reason = "The map holds no sweep of that name.";
  return withdrawal;
}

SweepResult Mapper::place(const Sweep& sweep, StageListener* stages) {
  begin_stage(stages, "prepare");
  PlacedSweep placed;
  placed.name = sweep.name;
  placed.scan = PreparedScan::make(sweep.cloud, sweep.origin, registration_, stages);
  placed.origin = sweep.origin;
  placed.R_world_sweep = sweep.R_world_sweep;
  placed.session = session_;
  return graph_.empty() ? place_first(sweep, std::move(placed)) : place_among(sweep, std::move(placed), stages);
}

SweepResult Mapper::place_first(const Sweep& sweep, PlacedSweep placed) {
  SweepResult result;
  const std::size_t points = usable_points(sweep, robot_);
  if (points < kMinPoints) {
    result.reason = "only " + std::to_string(points) + " usable points, of at least " + std::to_string(kMinPoints);
    return result;
  }
  result.verdict = result.registration.verdict = Verdict::accepted;
  result.reason = result.registration.reason = "first sweep: the map begins here";
  result.registration.probability = 1.0;
  result.X_map_sweep = placed.X_map_sweep = map_.first_pose(sweep);
  graph_.begin(std::move(placed));
  return result;
}

SweepResult Mapper::place_among(const Sweep& sweep, PlacedSweep placed, StageListener* stages) {
  SweepResult result;
  const std::vector<PlacedSweep>& map = graph_.sweeps();
  const bool continued = map.back().session != placed.session;
  const Location location = locator_.locate(placed, map, stages);
  if (location.links.empty()) {
    report_against(map[*location.refused_by].name, *location.refusal, result);
    result.reason = said_of_refusal(location, map, continued);
    return result;
  }
  const Link& first = location.links.front();
  report_against(map[first.target].name, first.registration, result);
  begin_stage(stages, "movement");
  result.movement = movement_of(sweep, placed, location.links, map);
  placed.stood_still = result.movement.robot.known && !result.movement.robot.moved;
  if (breaks_sweep(result.movement.robot)) {
    result.reason = "No one pose is right for all of the sweep." + said_of(result.movement);
    return result;
  }
  begin_stage(stages, "graph");
  if (!graph_.add(std::move(placed), location.links)) {
    result.reason = "Its registrations contradict the map.";
    return result;
  }
  const Link& best = best_of(location.links, graph_.solution());
  report_against(map[best.target].name, best.registration, result);
  result.verdict = Verdict::accepted;
  result.reason = best.registration.reason + said_of_links(location.links, graph_) + said_of(result.movement);
  result.X_map_sweep = map.back().X_map_sweep;
  return result;
}

/// Of the sweeps that the products hold.
MapCorrection Mapper::correction() const {
  MapCorrection correction;
  for (std::size_t i = 0; i < trajectory_.size(); ++i) {
    if (trajectory_[i].withdrawn) continue;
    const PlacedSweep& sweep = graph_.sweeps()[i];
    const Pose& held = trajectory_[i].X_map_sweep;
    correction.shift_m = std::max(correction.shift_m, (sweep.X_map_sweep * sweep.origin - held * sweep.origin).norm());
    correction.turn = std::max(correction.turn, rotation_angle(held.linear().transpose() * sweep.X_map_sweep.linear()));
  }
  const bool moved = correction.shift_m > tolerated_.shift_m || correction.turn > tolerated_.turn;
  correction.remade = moved ? trajectory_.size() : 0;
  return correction;
}

/// The moves that lead the products to where the graph has the sweeps.
std::vector<SweepMove> Mapper::follow_poses() {
  std::vector<SweepMove> moves;
  for (std::size_t i = 0; i < trajectory_.size(); ++i) {
    const Pose& now = graph_.sweeps()[i].X_map_sweep;
    if (trajectory_[i].withdrawn) continue;
    if (now.matrix() != trajectory_[i].X_map_sweep.matrix()) moves.push_back({i, now});
    trajectory_[i].X_map_sweep = now;
  }
  return moves;
}

}  // namespace scanway
