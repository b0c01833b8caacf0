#include "modules/mapper/core/octomap/sweep_voxels.h"

#include <tbb/enumerable_thread_specific.h>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/octomap/key_ray.h"
#include "modules/mapper/core/octomap/occupancy_tree.h"
#include "modules/mapper/core/octomap/ray_lanes.h"

namespace scanway {
namespace {

constexpr std::size_t kRaysInBlock = 1 << 16;

octomap::point3d to_octomap(const Eigen::Vector3f& p) { return {p.x(), p.y(), p.z()}; }

/// The centres of the voxels that hold a point, each once.
std::vector<Eigen::Vector3f> discretised(const std::vector<Eigen::Vector3f>& points, const KeyGrid& grid) {
  std::vector<Eigen::Vector3f> centres;
  VoxelBricks seen;
  for (const Eigen::Vector3f& p : points) {
    const octomap::OcTreeKey key = grid.wrapped_key_of(to_octomap(p));
    if (!seen.insert_occupied(morton_code(key))) continue;
    const octomap::point3d centre = grid.centre(key);
    centres.emplace_back(centre.x(), centre.y(), centre.z());
  }
  return centres;
}

/// The rays of a sweep to any of its points.
class Tracer {
 public:
  Tracer(const KeyGrid& grid, const octomap::point3d& origin, double max_range_m)
      : grid_(grid), origin_(origin), max_range_m_(max_range_m), rays_(grid, origin) {}

  /// Rays `begin` to `end`, side by side in the lanes those that are far apart in the sweep: neighbours would mark the
  /// same words, one waiting for the other.
  void trace(const std::vector<Eigen::Vector3f>& points, std::size_t begin, std::size_t end,
             VoxelBricks& bricks) const {
    RayLanes lanes(bricks);
    const std::size_t stride = (end - begin + RayLanes::kLanes - 1) / RayLanes::kLanes;
    for (std::size_t i = 0; i < stride; ++i) {
      for (std::size_t at = begin + i; at < end; at += stride) trace(to_octomap(points[at]), lanes, bricks);
    }
    lanes.finish();
  }

 private:
  void trace(const octomap::point3d& point, RayLanes& lanes, VoxelBricks& bricks) const {
    const octomap::point3d beam = point - origin_;
    if (max_range_m_ < 0.0 || beam.norm() <= max_range_m_) {
      octomap::OcTreeKey key;
      if (grid_.key_of(point, key)) bricks.insert_occupied(morton_code(key));
      add_ray(point, lanes, bricks);
    } else {
      add_ray(origin_ + beam.normalized() * static_cast<float>(max_range_m_), lanes, bricks);
    }
  }

  void add_ray(const octomap::point3d& end, RayLanes& lanes, VoxelBricks& bricks) const {
    KeyRay ray;
    if (!rays_.start(end, ray)) return;
    const MortonCode origin = rays_.origin_code();
    bricks.at(origin >> kBrickBits).free[origin / 64 % kBrickWords] |= std::uint64_t{1} << (origin % 64);
    lanes.add(ray);
  }

  KeyGrid grid_;
  octomap::point3d origin_;
  double max_range_m_;
  KeyRays rays_;
};

}  // namespace

VoxelBricks sweep_voxels(const std::vector<Eigen::Vector3f>& points, const octomap::point3d& origin,
                         const KeyGrid& grid, const OccupancyTreeConfig& config) {
  std::vector<Eigen::Vector3f> centres;
  if (config.discretize) centres = discretised(points, grid);
  const std::vector<Eigen::Vector3f>& ends = config.discretize ? centres : points;
  const Tracer tracer(grid, origin, config.max_range_m > 0.0 ? config.max_range_m : -1.0);
  tbb::enumerable_thread_specific<VoxelBricks> of_thread;
  for_blocks(ends.size(), kRaysInBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    tracer.trace(ends, begin, end, of_thread.local());
  });
  VoxelBricks all = std::move(of_thread.local());
  for (VoxelBricks& bricks : of_thread) all.merge(bricks);
  return all;
}

}  // namespace scanway
