#pragma once

#include <string>

namespace scanway::tools {

struct InfoOptions {
  std::string log;
  bool json = false;
};

/// `scanway info`: what a log holds. Returns 1 when the log was cut or has damaged events. Throws InputError.
int run_info(const InfoOptions& options);

}  // namespace scanway::tools
