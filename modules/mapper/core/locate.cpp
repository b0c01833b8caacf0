#include "modules/mapper/core/locate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modules/mapper/core/overlap.h"

namespace scanway {
namespace {

constexpr std::size_t kMostLinks = 4;
constexpr std::size_t kMostSearched = 3;  // of the same session: the last accepted sweep and two before it
constexpr double kLeastTilt = 0.11;       // radians: as the search with a tracker allows near iron

bool is_first_of_session(const PlacedSweep& sweep, const std::vector<PlacedSweep>& map) {
  return map.back().session != sweep.session;
}

/// Whether the trackers, which know no common heading, contradict a pose by where they say that up is.
bool is_tilted(const PlacedSweep& sweep, const PlacedSweep& target, const Pose& T_target_sweep, double sigma) {
  const auto ours = up_of(sweep), theirs = up_of(target);
  if (!ours || !theirs) return false;
  return (T_target_sweep.linear() * *ours - *theirs).norm() > std::max(4.0 * std::sqrt(2.0) * sigma, kLeastTilt);
}

/// Of several refusals the one against the newest target is reported.
void take(Location& location, std::size_t target, RegistrationResult registration) {
  if (registration.verdict == Verdict::accepted) {
    location.links.push_back({target, std::move(registration)});
  } else if (!location.refusal) {
    location.refusal = std::move(registration);
    location.refused_by = target;
  }
}

}  // namespace

std::optional<Eigen::Vector3d> up_of(const PlacedSweep& sweep) {
  if (!sweep.R_world_sweep) return std::nullopt;
  return sweep.R_world_sweep->normalized().conjugate() * Eigen::Vector3d::UnitZ();
}

Location Locator::locate(const PlacedSweep& sweep, const std::vector<PlacedSweep>& map, StageListener* stages) const {
  Location location;
  const bool everywhere = is_first_of_session(sweep, map);
  for (std::size_t target = map.size(); target-- > 0 && (everywhere || map.size() - target <= kMostSearched);) {
    take(location, target, link(sweep, map[target], stages));
    if (!everywhere && !location.links.empty()) break;
  }
  if (location.links.empty() || everywhere) return location;

  const Link first = location.links.front();
  // Rigid transforms compose as matrices: X_ms = X_mt T_ts, so R_ms = R_mt R_ts and t_ms = R_mt t_ts + t_mt. The paper
  // writes R_ref = R R_ICP, T_ref = T + T_ICP: the same where T_ICP is stated in the axes that R leads to
  // (T_ICP = R t_ICP) while R_ICP turns about the axes of the source.
  const Pose X_map_sweep = map[first.target].X_map_sweep * first.registration.T_target_source;
  begin_stage(stages, "overlap");
  for (const std::size_t target : most_overlapping(sweep, X_map_sweep, map, kMostLinks)) {
    if (target != first.target && location.links.size() < kMostLinks) {
      take(location, target, link(sweep, map[target], stages));
    }
  }
  return location;
}

RegistrationResult Locator::link(const PlacedSweep& sweep, const PlacedSweep& target, StageListener* stages) const {
  const std::optional<OrientationPrior> known = prior(sweep, target);
  RegistrationResult result = register_scans(sweep.scan, target.scan, known, config_, stages);
  if (!known && is_tilted(sweep, target, result.T_target_source, tracker_.tilt_sigma)) {
    result.verdict = Verdict::refused;
    result.reason = "The pose leans against what the tracker says is up.";
  }
  return result;
}

std::optional<OrientationPrior> Locator::prior(const PlacedSweep& source, const PlacedSweep& target) const {
  const bool comparable = source.session == target.session && source.R_world_sweep && target.R_world_sweep;
  if (!comparable) return std::nullopt;
  // Each of the two readings has the tracker's error, so their difference has sqrt(2) of it.
  return OrientationPrior{
      (target.R_world_sweep->normalized().conjugate() * source.R_world_sweep->normalized()).toRotationMatrix(),
      std::sqrt(2.0) * tracker_.heading_sigma, std::sqrt(2.0) * tracker_.tilt_sigma};
}

}  // namespace scanway
