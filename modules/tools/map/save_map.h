#pragma once

#include <string>

namespace scanway::tools {

struct SaveMapOptions {
  std::string sweeps;  ///< What scanway-mapper --state or scanway replay --keep has kept, or a saved map.
  std::string robot;   ///< Robot file; empty: the saved map's, or the built-in ERA-Mobi.
  std::string output;  ///< Folder.
};

/// `scanway map save`: the map of kept sweeps, made again and saved whole. Throws InputError; the folder then holds
/// what it held.
int run_save_map(const SaveMapOptions& options);

/// `scanway map check`: whether a saved map is what was saved. Throws InputError that names the file which is not.
int run_check_map(const std::string& folder);

}  // namespace scanway::tools
