#pragma once

#include <string>
#include <vector>

namespace scanway::tools {

struct OctomapOptions {
  std::vector<std::string> clouds;
  std::string poses;  ///< X_map_scan of every cloud, as PosesFile reads them.
  double resolution_m = 0.0;
  double max_range_m = 0.0;  ///< Not above 0: beams are not cut off.
  bool discretize = false;
  bool json = false;
  std::string output;  ///< MAP.ot or MAP.bt.
};

/// `scanway octomap`: the OctoMap that liboctomap's insertPointCloud makes of clouds in the order given, each from its
/// pose's position. Throws InputError; no map is left then.
int run_octomap(const OctomapOptions& options);

}  // namespace scanway::tools
