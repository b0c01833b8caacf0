#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "common/cloud/point_cloud.h"
#include "common/geometry/pose.h"
#include "common/progress/stages.h"

namespace scanway {

/// What the orientation tracker knows of the answer. Its error: heading and tilt (roll and pitch each), as deviations.
struct OrientationPrior {
  Eigen::Matrix3d R_target_source = Eigen::Matrix3d::Identity();
  double heading_sigma = 0.0873;  ///< Radians.
  double tilt_sigma = 0.0087;     ///< Radians.
};

struct RegistrationConfig {
  double min_range_m = 0.3;  ///< Nearer points are the robot itself, or marks.
  double max_range_m = 80.0;
  std::uint64_t seed = 1;
};

enum class Verdict { accepted, refused };

struct RegistrationResult {
  Pose T_target_source = Pose::Identity();  ///< p_target = T_target_source * p_source.
  Verdict verdict = Verdict::refused;
  std::string reason;          ///< One sentence for people: why it was accepted or refused.
  double probability = 0.0;    ///< That T_target_source is right (within 0.1 m and 0.5 degrees).
  double overlap = 0.0;        ///< Share of source points (one a 0.1 m voxel) with a target point within 0.3 m.
  double inlier_rmse_m = 0.0;  ///< Of the point-to-plane distances of the last ICP's inliers.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();  ///< rotation vector, translation.
  std::vector<std::string> open_directions;  ///< What the scene leaves open, by name ("slides along 12 degrees").
};

/// A scan made ready for registration once, as source or target of any number of pairs: voxel grids, normals, features,
/// surfaces, neighbour index. Immutable, cheap to copy.
class PreparedScan {
 public:
  struct Data;
  /// `cloud` in the scan's frame; `origin`, the sensor's centre in that frame. Points that are not finite or out of the
  /// configured range are left out. A cloud of any content is accepted; what cannot be registered is refused later.
  static PreparedScan make(const PointCloud& cloud, const Eigen::Vector3d& origin, const RegistrationConfig& config,
                           StageListener* stages = nullptr);
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// The paper's chain: orientation first, FPFH, rigid transform by SVD, point-to-plane ICP on points of chosen surfaces,
/// and then a verdict. Without a prior, the orientation is searched too.
RegistrationResult register_scans(const PreparedScan& source, const PreparedScan& target,
                                  const std::optional<OrientationPrior>& prior, const RegistrationConfig& config,
                                  StageListener* stages = nullptr);

}  // namespace scanway
