#pragma once

#include <optional>
#include <string>
#include <vector>

namespace scanway::tools {

struct SpyOptions {
  std::string channel;  ///< Whose values to show; empty: a table of all channels.
  std::string lcm_url;  ///< Empty: LCM_DEFAULT_URL, or LCM's default.
  std::optional<double> seconds;
  bool once = false;
  bool json = false;
  unsigned elements = 8;         ///< Of an array, for people.
  std::string relay;             ///< URL of a second bus that gets everything, objects whole; empty: none.
  std::vector<std::string> ask;  ///< Channels whose objects are asked for.
};

/// `scanway spy`: what is on the bus. Returns 1 when a channel was asked for and nothing good came. Throws InputError.
int run_spy(const SpyOptions& options);

}  // namespace scanway::tools
