#pragma once

#include <string>

namespace scanway::tools {

struct ReplayOptions {
  std::string log;
  std::string output;     ///< Not with `verify`.
  std::string played;     ///< With `verify`: the log that was played to the processes; empty: none.
  std::string continued;  ///< Folder of the map that the log goes on with in the same session; empty: none.
  std::string resumed;    ///< Folder of the map that the log goes on with; empty: none.
  std::string kept;       ///< Folder to keep the map's sweeps in; empty: they are not kept.
  std::string robot;      ///< Robot file in place of the log's own configuration; empty: the log's.
};

/// `scanway replay`: the nodes in one process over a log, and every product in one folder. Returns 1 when the log was
/// cut. Throws InputError.
int run_replay(const ReplayOptions& options);

/// `scanway replay --verify`: says whether what the log holds of products is what its inputs give. Returns 0 if so, 1
/// if one differs, 3 if there is none, 4 if inputs are missing. Throws InputError.
int run_verify(const ReplayOptions& options);

}  // namespace scanway::tools
