#include "modules/mapper/core/locate.h"

#include <algorithm>
#include <cmath>

#include "modules/mapper/core/overlap.h"

namespace scanway {
namespace {

constexpr std::size_t kMostLinks = 4;
constexpr std::size_t kMostSearched = 3;  // of the same session: the last accepted sweep and two before it

/// The map's sweeps, newest first; of a session that has none yet, all, else its last ones.
std::vector<std::size_t> search_order(const PlacedSweep& sweep, const std::vector<PlacedSweep>& map) {
  std::vector<std::size_t> order;
  const bool goes_on = map.back().session == sweep.session;
  for (std::size_t i = map.size(); i-- > 0;) {
    if (!goes_on || order.size() < kMostSearched) order.push_back(i);
  }
  return order;
}

}  // namespace

Location Locator::locate(const PlacedSweep& sweep, const std::vector<PlacedSweep>& map, StageListener* stages) const {
  Location location;
  for (const std::size_t target : search_order(sweep, map)) {
    RegistrationResult registration = link(sweep, map[target], stages);
    if (registration.verdict == Verdict::accepted) {
      location.links.push_back({target, std::move(registration)});
      break;
    }
    // The refusal that is reported is the one against the newest target.
    if (!location.refusal) location.refusal = std::move(registration), location.refused_by = target;
  }
  if (location.links.empty()) return location;

  const std::size_t first = location.links.front().target;
  // Rigid transforms compose as matrices: X_ms = X_mt T_ts, so R_ms = R_mt R_ts and t_ms = R_mt t_ts + t_mt. The paper
  // writes R_ref = R R_ICP, T_ref = T + T_ICP: the same where T_ICP is stated in the axes that R leads to
  // (T_ICP = R t_ICP) while R_ICP turns about the axes of the source.
  const Pose X_map_sweep = map[first].X_map_sweep * location.links.front().registration.T_target_source;
  begin_stage(stages, "overlap");
  for (const std::size_t target : most_overlapping(sweep, X_map_sweep, map, kMostLinks)) {
    if (location.links.size() == kMostLinks) break;
    if (target == first) continue;
    RegistrationResult registration = link(sweep, map[target], stages);
    if (registration.verdict == Verdict::accepted) location.links.push_back({target, std::move(registration)});
  }
  return location;
}

RegistrationResult Locator::link(const PlacedSweep& sweep, const PlacedSweep& target, StageListener* stages) const {
  return register_scans(sweep.scan, target.scan, prior(sweep, target), config_, stages);
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
