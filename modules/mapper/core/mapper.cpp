#include "modules/mapper/core/mapper.h"

#include <cmath>

namespace scanway {
namespace {

constexpr std::size_t kMaxTargets = 3;    // the last accepted sweep and two before it
constexpr std::size_t kMinPoints = 1000;  // fewer show no place that could be found again

std::size_t usable_points(const Sweep& sweep, const Robot& robot) {
  return points_in_map(sweep, Pose::Identity(), robot.laser.min_range_m, robot.laser.max_range_m).points.size();
}

}  // namespace

Mapper::Mapper(const Robot& robot, std::uint64_t seed)
    : robot_(robot), registration_{robot.laser.min_range_m, robot.laser.max_range_m, seed}, map_(robot, seed) {}

SweepResult Mapper::add(const Sweep& sweep, StageListener* stages) {
  begin_stage(stages, "prepare");
  const PreparedScan scan = PreparedScan::make(sweep.cloud, sweep.origin, registration_, stages);

  SweepResult result = targets_.empty() ? place_first(sweep, scan) : place(sweep, scan, stages);
  result.name = sweep.name;
  result.utime = sweep.utime;
  result.change.version = map_.version();

  if (result.verdict == Verdict::accepted) {
    result.change = map_.merge(sweep, result.X_map_sweep, stages);
    trajectory_.push_back({sweep.utime, result.X_map_sweep});
    targets_.insert(targets_.begin(), {sweep.name, scan, sweep.R_world_sweep, result.X_map_sweep});
    if (targets_.size() > kMaxTargets) targets_.pop_back();
  }
  begin_stage(stages, "");
  results_.push_back(result);
  return result;
}

SweepResult Mapper::place_first(const Sweep& sweep, const PreparedScan&) const {
  SweepResult result;
  const std::size_t points = usable_points(sweep, robot_);
  if (points < kMinPoints) {
    result.reason = "only " + std::to_string(points) + " usable points, of at least " + std::to_string(kMinPoints);
    return result;
  }
  result.verdict = result.registration.verdict = Verdict::accepted;
  result.reason = result.registration.reason = "first sweep: the map begins here";
  result.registration.probability = 1.0;
  result.X_map_sweep = map_.first_pose(sweep);
  return result;
}

SweepResult Mapper::place(const Sweep& sweep, const PreparedScan& scan, StageListener* stages) const {
  SweepResult result;
  for (const AcceptedSweep& target : targets_) {
    RegistrationResult registration = register_scans(scan, target.scan, prior(sweep, target), registration_, stages);
    const bool accepted = registration.verdict == Verdict::accepted;
    // The refusal that is reported is the one against the newest target.
    if (!accepted && !result.target.empty()) continue;
    result.verdict = registration.verdict;
    result.reason = registration.reason;
    result.target = target.name;
    result.registration = std::move(registration);
    // Rigid transforms compose as matrices: X_ms = X_mt T_ts, so R_ms = R_mt R_ts and t_ms = R_mt t_ts + t_mt. The
    // paper writes R_ref = R R_ICP, T_ref = T + T_ICP: the same where T_ICP is stated in the axes that R leads to
    // (T_ICP = R t_ICP) while R_ICP turns about the axes of the source.
    result.X_map_sweep = target.X_map_sweep * result.registration.T_target_source;
    if (accepted) break;
  }
  return result;
}

std::optional<OrientationPrior> Mapper::prior(const Sweep& source, const AcceptedSweep& target) const {
  if (!source.R_world_sweep || !target.R_world_sweep) return std::nullopt;
  // Each of the two readings has the tracker's error, so their difference has sqrt(2) of it.
  return OrientationPrior{
      (target.R_world_sweep->normalized().conjugate() * source.R_world_sweep->normalized()).toRotationMatrix(),
      std::sqrt(2.0) * robot_.tracker.heading_sigma, std::sqrt(2.0) * robot_.tracker.tilt_sigma};
}

}  // namespace scanway
