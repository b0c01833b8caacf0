#pragma once

#include <string>

namespace scanway::tools {

struct ReplayOptions {
  std::string log;
  std::string output;
  std::string robot;  ///< Robot file in place of the log's own configuration; empty: the log's.
};

/// `scanway replay`: the nodes in one process over a log, and every product in one folder. Returns 1 when the log was
/// cut. Throws InputError.
int run_replay(const ReplayOptions& options);

}  // namespace scanway::tools
