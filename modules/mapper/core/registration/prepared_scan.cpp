#include "modules/mapper/core/registration/prepared_scan.h"

#include <cmath>

#include "modules/mapper/core/registration/eigen3.h"
#include "modules/mapper/core/registration/fpfh.h"
#include "modules/mapper/core/registration/neighbourhoods.h"
#include "modules/mapper/core/registration/normals.h"
#include "modules/mapper/core/registration/voxel_grid.h"

namespace scanway {
namespace {

using namespace registration;

constexpr float kFineVoxel = 0.1f;      // metres
constexpr float kFineCell = 0.3f;       // the distance at which overlap is counted
constexpr float kFeatureVoxel = 0.3f;   // thinning for features: their neighbourhoods then hold some 70 points
constexpr float kNormalRadius = 0.9f;   // three voxels
constexpr float kFeatureRadius = 1.5f;  // five voxels
constexpr float kSurfaceReach = 1.0f;   // cell of the surfaces' index
constexpr std::size_t kKeypoints = 3000;
constexpr std::size_t kFewSurfaces = 1200, kFewestSurfaces = 500;
constexpr std::size_t kMinPoints = 200;
constexpr std::size_t kMinSurfaces = 20;

/// The points that a laser measured, relative to the sensor, thinned.
Points measured_points(const PointCloud& cloud, const Eigen::Vector3d& origin, const RegistrationConfig& config) {
  VoxelGrid grid(kFineVoxel, cloud.size());
  const double low = config.min_range_m * config.min_range_m, high = config.max_range_m * config.max_range_m;
  for (const Eigen::Vector3f& p : cloud.points) {
    const Eigen::Vector3d relative = p.cast<double>() - origin;
    const double range2 = relative.squaredNorm();
    if (range2 >= low && range2 <= high) grid.add(relative.cast<float>());  // NaN compares false
  }
  return grid.take_centroids();
}

/// Three directions of normals must be there, or the surfaces cannot hold a pose.
bool all_on_one_plane(const Surfaces& surfaces) {
  Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3f& n : surfaces.normal) outer += n.cast<double>() * n.cast<double>().transpose();
  return symmetric_eigen(outer).values[1] < 0.005 * static_cast<double>(surfaces.count());
}

std::string defect_of(const Points& points, const Surfaces& surfaces) {
  if (points.empty()) return "holds no point in range";
  if (points.size() < kMinPoints) return "holds only " + std::to_string(points.size()) + " places in range";
  if (surfaces.count() < kMinSurfaces) return "shows no surfaces to hold on to";
  if (all_on_one_plane(surfaces)) return "shows surfaces of one direction only";
  return {};
}

Keypoints find_keypoints(const Points& points, StageListener* stages) {
  const CellGrid grid(voxel_centroids(points, kFeatureVoxel), kFeatureRadius / 2);
  begin_stage(stages, "neighbours");
  const Neighbourhoods neighbourhoods = find_neighbourhoods(grid, kFeatureRadius);
  begin_stage(stages, "normals");
  const Normals normals = estimate_normals(grid.points(), neighbourhoods, kNormalRadius);
  begin_stage(stages, "fpfh");
  return choose_keypoints(grid.points(), normals, compute_fpfh(grid.points(), normals, neighbourhoods), kKeypoints);
}

}  // namespace

PreparedScan PreparedScan::make(const PointCloud& cloud, const Eigen::Vector3d& origin,
                                const RegistrationConfig& config, StageListener* stages) {
  auto data = std::make_shared<Data>();
  begin_stage(stages, "voxels");
  data->origin = origin;
  const Points fine = measured_points(cloud, origin, config);
  data->fine = CellGrid(fine, kFineCell);
  data->image = RangeImage(fine);
  begin_stage(stages, "surfaces");
  data->surfaces = choose_surfaces(fine);
  data->few_surfaces = thin_surfaces(data->surfaces, kFewSurfaces);
  data->fewest_surfaces = thin_surfaces(data->surfaces, kFewestSurfaces);
  data->surface_grid = CellGrid(data->surfaces.centre, kSurfaceReach);
  data->defect = defect_of(fine, data->surfaces);
  if (data->defect.empty()) data->keypoints = find_keypoints(fine, stages);
  begin_stage(stages, "");
  PreparedScan scan;
  scan.data_ = std::move(data);
  return scan;
}

}  // namespace scanway
