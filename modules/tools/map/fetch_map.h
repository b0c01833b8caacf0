#pragma once

#include <string>

#include "modules/tools/map/map_copy.h"

namespace scanway::tools {

struct FetchMapOptions {
  std::string lcm_url;  ///< Empty: LCM_DEFAULT_URL, or LCM's default.
  MapDetail detail;
  double limit_s = 600.0;
  std::string output;  ///< Folder.
};

/// `scanway map fetch`: the map over a slow link (scanway-link), whole: costmap.yaml, map.pcd, map.bt in one saved
/// folder. Says every second what is here. Returns 1, and writes nothing, when it is not whole within the limit. Throws
/// InputError.
int run_fetch_map(const FetchMapOptions& options);

}  // namespace scanway::tools
