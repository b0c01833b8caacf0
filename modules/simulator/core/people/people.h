#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "modules/simulator/core/people/walk.h"
#include "modules/simulator/core/ray/ray_caster.h"

namespace scanway::simulator {

/// Persons who walk about while the robot scans. Rays meet them where they are at the ray's own time.
class People {
 public:
  /// Nobody.
  People() = default;
  /// `count` of them within some metres of `place`, a point on the ground; fewer if there is no room. The seed decides
  /// where and how fast each one walks, and nothing else does. `world` need not outlive this.
  People(const RayCaster& world, const Eigen::Vector3d& place, int count, std::uint64_t seed);

  bool empty() const { return walks_.empty(); }
  std::size_t size() const { return walks_.size(); }
  /// Where the feet of person `i` are. Times are microseconds of any one clock.
  Pose X_world_person(std::size_t i, double time_us) const { return walks_[i].X_world_person(time_us); }

  /// Puts a person in place of each hit that lies behind one. Thread-safe.
  void stand_before(RayCaster::FourHits& hits, const Eigen::Vector3d& origin, const RayCaster::Four& directions,
                    double max_range_m, double time_us) const;

 private:
  std::vector<Walk> walks_;
  std::shared_ptr<const RayCaster> body_;  // In the person's own frame; all are of one build.
};

}  // namespace scanway::simulator
