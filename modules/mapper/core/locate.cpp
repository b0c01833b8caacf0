#include "modules/mapper/core/locate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modules/mapper/core/overlap.h"
#include "modules/mapper/core/registration/prepared_scan.h"

namespace scanway {
namespace {

constexpr std::size_t kMostLinks = 4;
constexpr std::size_t kMostSearched =
    32;                              // sweeps of the map: some 20 s of work, of the two minutes that a sweep takes
constexpr double kMostDoubt = 0.15;  // that any of the places asked took it wrongly: as the verdict's for one
constexpr double kLeastTilt = 0.11;  // radians: as the search with a tracker allows near iron

/// Whether the trackers, which know no common heading, contradict a pose by where they say that up is.
bool is_tilted(const PlacedSweep& sweep, const PlacedSweep& target, const Pose& T_target_sweep, double sigma) {
  const auto ours = up_of(sweep), theirs = up_of(target);
  if (!ours || !theirs) return false;
  return (T_target_sweep.linear() * *ours - *theirs).norm() > std::max(4.0 * std::sqrt(2.0) * sigma, kLeastTilt);
}

/// One chance more to be wrong with each place that was asked (Bonferroni's bound).
bool is_certain(const RegistrationResult& registration, std::size_t asked) {
  return (1.0 - registration.probability) * static_cast<double>(asked) <= kMostDoubt;
}

/// The sweep that says how its tracker's heading lies in the map: the target itself, or the newest of its session.
const PlacedSweep* known_heading(const PlacedSweep& sweep, const std::vector<PlacedSweep>& map, std::size_t target) {
  const auto tells = [&](const PlacedSweep& other) {
    return other.session == sweep.session && other.R_world_sweep && !other.withdrawn;
  };
  if (tells(map[target])) return &map[target];
  const auto newest = std::find_if(map.rbegin(), map.rend(), tells);
  return newest == map.rend() ? nullptr : &*newest;
}

/// As sure as the verdict is of one pair, but not of one among so many.
void refuse_as_uncertain(Location& location) {
  Link only = std::move(location.links.front());
  location.links.clear();
  only.registration.verdict = Verdict::refused;
  only.registration.reason = "Too unsure for one of " + std::to_string(location.searched) +
                             " places, and no other sweep confirms it: " + only.registration.reason;
  location.refused_by = only.target;
  location.refusal = std::move(only.registration);
}

}  // namespace

std::optional<Eigen::Vector3d> up_of(const PlacedSweep& sweep) {
  if (!sweep.R_world_sweep) return std::nullopt;
  return sweep.R_world_sweep->normalized().conjugate() * Eigen::Vector3d::UnitZ();
}

Location Locator::locate(const PlacedSweep& sweep, const std::vector<PlacedSweep>& map, StageListener* stages) const {
  Location location;
  const std::optional<Found> found = find(sweep, map, location, stages);
  if (!found) return location;

  const Link& first = found->link;
  // Rigid transforms compose as matrices: X_ms = X_mt T_ts, so R_ms = R_mt R_ts and t_ms = R_mt t_ts + t_mt. The paper
  // writes R_ref = R R_ICP, T_ref = T + T_ICP: the same where T_ICP is stated in the axes that R leads to
  // (T_ICP = R t_ICP) while R_ICP turns about the axes of the source.
  const Pose X_map_sweep = map[first.target].X_map_sweep * first.registration.T_target_source;
  location.links.push_back(first);
  begin_stage(stages, "overlap");
  for (const std::size_t target : most_overlapping(sweep, X_map_sweep, map, kMostLinks)) {
    if (target == first.target || location.links.size() == kMostLinks) continue;
    RegistrationResult registration = link(sweep, map, target, stages);
    if (registration.verdict == Verdict::accepted) location.links.push_back({target, std::move(registration)});
  }
  if (!found->certain && location.links.size() == 1) refuse_as_uncertain(location);
  return location;
}

/// The first of the map's sweeps that takes it for certain, else the most probable that takes it. Of several refusals
/// the first is reported, which is that of the place where the robot was last.
std::optional<Locator::Found> Locator::find(const PlacedSweep& sweep, const Sweeps& map, Location& location,
                                            StageListener* stages) const {
  std::optional<Found> best;
  for (const std::size_t target : nearest_to_last(map, kMostSearched)) {
    RegistrationResult registration = link(sweep, map, target, stages);
    ++location.searched;
    const bool accepted = registration.verdict == Verdict::accepted;
    if (accepted && is_certain(registration, location.searched)) return Found{{target, std::move(registration)}, true};
    if (accepted && (!best || registration.probability > best->link.registration.probability)) {
      best = Found{{target, std::move(registration)}, false};
    } else if (!accepted && !location.refusal) {
      location.refused_by = target;
      location.refusal = std::move(registration);
    }
    if (!sweep.scan.data().defect.empty()) break;  // No place will take it.
  }
  return best;
}

RegistrationResult Locator::link(const PlacedSweep& sweep, const Sweeps& map, std::size_t target,
                                 StageListener* stages) const {
  const std::optional<OrientationPrior> known = prior(sweep, map, target);
  RegistrationResult result = register_scans(sweep.scan, map[target].scan, known, config_, stages);
  if (!known && is_tilted(sweep, map[target], result.T_target_source, tracker_.tilt_sigma)) {
    result.verdict = Verdict::refused;
    result.reason = "The pose leans against what the tracker says is up.";
  }
  return result;
}

std::optional<OrientationPrior> Locator::prior(const PlacedSweep& sweep, const Sweeps& map, std::size_t target) const {
  const PlacedSweep* known = sweep.R_world_sweep ? known_heading(sweep, map, target) : nullptr;
  if (known == nullptr) return std::nullopt;
  Eigen::Matrix3d R_target_known = Eigen::Matrix3d::Identity();
  if (known != &map[target])
    R_target_known = map[target].X_map_sweep.linear().transpose() * known->X_map_sweep.linear();
  const Eigen::Matrix3d R_known_sweep =
      (known->R_world_sweep->normalized().conjugate() * sweep.R_world_sweep->normalized()).toRotationMatrix();
  // Each of the two readings has the tracker's error, so their difference has sqrt(2) of it.
  return OrientationPrior{R_target_known * R_known_sweep, std::sqrt(2.0) * tracker_.heading_sigma,
                          std::sqrt(2.0) * tracker_.tilt_sigma};
}

}  // namespace scanway
