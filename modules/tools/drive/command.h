#pragma once

#include <optional>
#include <string>

namespace scanway::tools {

struct CommandOptions {
  std::string what;  ///< sweep, move, turn, reference, stop, fast-stop, acknowledge
  std::optional<double> pan_deg, tilt_deg, pan_speed_deg_s, tilt_speed_deg_s;
  bool registered = false;  ///< sweep: wait until the mapper has said what became of it.
  std::string lcm_url;      ///< Empty: LCM_DEFAULT_URL, or LCM's default.
};

/// `scanway command`: tells the pan-tilt what to do, again until its bridge has heard it; waits for the end of a sweep,
/// or for its place in the map. Returns 1 when it was refused or the sweep was given up or refused. Throws InputError.
int run_command(const CommandOptions& options);

}  // namespace scanway::tools
