#pragma once

#include <string>
#include <vector>

#include "modules/replay/verify/recorded_log.h"

namespace scanway {

/// What a player sent to processes, and they did not use, as their recorded session says: sweeps that are in no
/// SWEEP_INPUTS, orientations that their sweep should have used, goals that no PATH answers. A line each; empty: they
/// had all of it. Nothing repeats what a player's datagrams lose, so the two logs are compared.
std::vector<std::string> not_used(const RecordedLog& played, const RecordedLog& session);

}  // namespace scanway
