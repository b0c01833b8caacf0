#pragma once

#include <string>

namespace scanway::tools {

struct WithdrawOptions {
  std::string sweep;    ///< As REGISTRATION names it.
  std::string lcm_url;  ///< Empty: LCM_DEFAULT_URL, or LCM's default.
};

/// `scanway map withdraw`: has the live mapper take a sweep out of its map, and waits until it has. Returns 1 when it
/// refused. Throws InputError when no mapper is heard.
int run_withdraw(const WithdrawOptions& options);

}  // namespace scanway::tools
