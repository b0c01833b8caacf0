#include "modules/mapper/core/sweep_movement.h"

namespace scanway {

Movement movement_of(const Sweep& sweep, const PlacedSweep& placed, const std::vector<Link>& links,
                     const std::vector<PlacedSweep>& map) {
  const DirectionTimes times(sweep);
  const PreparedScan::Data& scan = placed.scan.data();
  const Link& first = links.front();
  Movement movement;
  movement.scene = scene_movement(scan, map[first.target].scan.data(), first.registration.T_target_source);
  bool is_certain = false;
  for (const Link& link : links) {
    const PlacedSweep& target = map[link.target];
    const RobotMovement seen = robot_movement(times, scan, target.scan.data(), link.registration.T_target_source);
    if (!seen.known) continue;
    if (!seen.moved) {
      movement.robot = seen;
      return movement;
    }
    is_certain = is_certain || target.stood_still || movement.robot.known;
    if (!movement.robot.known) movement.robot = seen;
  }
  if (movement.robot.moved && !is_certain) movement.or_during = map[first.target].name;
  return movement;
}

}  // namespace scanway
