#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/random/random.h"
#include "modules/mapper/core/registration/registration.h"

namespace scanway::bench {

/// A set of real scans with reference poses, from ../shared/data.
struct RealSet {
  std::string name;
  std::vector<std::string> scans;  ///< Names, in the order of the poses file.
  std::vector<PointCloud> clouds;
  std::vector<Pose> X_ref_scan;
  double right_m = 0.1;  ///< How far from the reference a right pose may be (the set's own uncertainty).
  double right_angle = 0.0087;
  /// By its README's table, from scan to scan; pairs that it leaves out overlap less than 0.25. Empty without a table.
  std::map<std::pair<std::string, std::string>, double> stated_overlap;

  Pose T_target_source(std::size_t source, std::size_t target) const {
    return X_ref_scan[target].inverse() * X_ref_scan[source];
  }
};

/// The folders that load_set() knows.
const std::vector<std::string>& real_set_names();
/// `data`: the folder that holds the sets. Throws InputError. Points nearer than the set's README says are left out.
RealSet load_set(const std::string& data, const std::string& name);

/// The rotation of `T_target_source` as a tracker would give it: heading and tilt disturbed by these deviations.
OrientationPrior disturbed_prior(const Pose& T_target_source, double heading_sigma_deg, double tilt_sigma_deg,
                                 Random& random);
/// The same, turned by `angle_deg` about a random axis.
OrientationPrior turned_prior(const Pose& T_target_source, double angle_deg, Random& random);

/// Distance and angle of a result to the reference.
struct PoseError {
  double metres = 0.0;
  double radians = 0.0;
};
PoseError error_of(const Pose& T, const Pose& reference);

/// Share of source points with a target point within 0.3 m at a pose (every third point).
double true_overlap(const PointCloud& source, const PointCloud& target, const Pose& T_target_source);

}  // namespace scanway::bench
