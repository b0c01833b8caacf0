#include "modules/mapper/core/movement/scene_movement.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scanway {
namespace {

using registration::CellGrid;
using registration::Points;
using registration::RangeImage;

constexpr float kInView = 15.0f;          // metres from either sensor: farther, a person is a few pixels
constexpr float kApart = 0.3f;            // metres between a thing and what the other sweep has there
constexpr float kJoined = 0.35f;          // metres between neighbouring points of a thing
constexpr std::size_t kLeastPoints = 15;  // of a thing, one a 0.1 m voxel
constexpr float kLeastHeight = 0.8f;      // lower, thin tops and rails are seen from one side and not from the other

/// The points of one sweep where the other saw through.
struct SeenThrough {
  Points points;         ///< In their own sweep's frame, from its sensor.
  std::size_t seen = 0;  ///< Of all, how many the other had in view.
};

SeenThrough seen_through(const PreparedScan::Data& from, const PreparedScan::Data& to, const Pose& T_to_from) {
  SeenThrough result;
  const Eigen::Matrix3f R = T_to_from.linear().cast<float>();
  const Eigen::Vector3f t = T_to_from.translation().cast<float>();
  for (const Eigen::Vector3f& p : from.fine.points()) {
    const Eigen::Vector3f q = R * p + t;
    if (p.squaredNorm() > kInView * kInView || q.squaredNorm() > kInView * kInView) continue;
    const RangeImage::Sight sight = to.image.look(q);
    if (sight == RangeImage::Sight::unseen || sight == RangeImage::Sight::hidden) continue;
    ++result.seen;
    if (sight == RangeImage::Sight::free && !to.fine.any_within(q, kApart)) result.points.push_back(p);
  }
  return result;
}

/// Points that hang together.
struct Thing {
  std::size_t points = 0;
  float low = 0.0f, high = 0.0f, nearest = 0.0f;

  void add(const Eigen::Vector3f& p) {
    low = points == 0 ? p.z() : std::min(low, p.z());
    high = points == 0 ? p.z() : std::max(high, p.z());
    nearest = points == 0 ? p.norm() : std::min(nearest, p.norm());
    ++points;
  }
  bool is_one() const { return points >= kLeastPoints && high - low >= kLeastHeight; }
};

std::vector<Thing> things_of(const Points& points) {
  const CellGrid grid(points, kJoined);
  std::vector<bool> taken(grid.size(), false);
  std::vector<Thing> things;
  for (std::uint32_t first = 0; first < grid.size(); ++first) {
    if (taken[first]) continue;
    Thing thing;
    std::vector<std::uint32_t> front{first};
    taken[first] = true;
    while (!front.empty()) {
      const std::uint32_t at = front.back();
      front.pop_back();
      thing.add(grid.points()[at]);
      grid.for_each_within(grid.points()[at], kJoined, [&](std::uint32_t next, float) {
        if (!taken[next]) front.push_back(next);
        taken[next] = true;
      });
    }
    if (thing.is_one()) things.push_back(thing);
  }
  return things;
}

}  // namespace

SceneMovement scene_movement(const PreparedScan::Data& sweep, const PreparedScan::Data& target,
                             const Pose& T_target_sweep) {
  const Pose T = Eigen::Translation3d(-target.origin) * T_target_sweep * Eigen::Translation3d(sweep.origin);
  const SeenThrough ours = seen_through(sweep, target, T), theirs = seen_through(target, sweep, T.inverse());
  const std::vector<Thing> came = things_of(ours.points), gone = things_of(theirs.points);
  SceneMovement movement;
  movement.came = came.size();
  movement.gone = gone.size();
  std::size_t points = 0;
  for (const Thing& thing : came) points += thing.points;
  for (const Thing& thing : gone) points += thing.points;
  if (points > 0) movement.share = static_cast<double>(points) / static_cast<double>(ours.seen + theirs.seen);
  movement.nearest_m = came.empty() ? 0.0 : static_cast<double>(came.front().nearest);
  for (const Thing& thing : came) movement.nearest_m = std::min<double>(movement.nearest_m, thing.nearest);
  return movement;
}

}  // namespace scanway
