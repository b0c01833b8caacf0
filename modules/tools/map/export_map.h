#pragma once

#include <string>

namespace scanway::tools {

struct ExportMapOptions {
  std::string folder;  ///< A saved map.
  std::string output;  ///< Its name's end says the kind: .pcd, .ply, .las, .bt, .ot, .yaml (with .pgm beside it).
};

/// `scanway export`: a product of a saved map as a file. Throws InputError; no file is left then.
int run_export_map(const ExportMapOptions& options);

}  // namespace scanway::tools
