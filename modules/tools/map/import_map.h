#pragma once

#include <string>

namespace scanway::tools {

struct ImportMapOptions {
  std::string map;          ///< OctoMap (.bt, .ot) or map_server's YAML.
  std::string robot;        ///< Robot file: climbable step and height; empty: the built-in ERA-Mobi.
  double ground_z_m = 0.0;  ///< Of an OctoMap: where its ground is.
  std::string output;       ///< MAP.yaml.
};

/// `scanway import map`: a map of another program as one to plan on (`scanway plan`). Throws InputError; no map is left
/// then.
int run_import_map(const ImportMapOptions& options);

}  // namespace scanway::tools
