#pragma once

#include <vector>

#include "common/cloud/sweep.h"
#include "modules/mapper/core/locate.h"
#include "modules/mapper/core/movement/movement.h"

namespace scanway {

/// What moved while `sweep` was taken, by all that it was registered to: a robot that moved contradicts each of them.
/// Whatever stood still with one, stood still.
Movement movement_of(const Sweep& sweep, const PlacedSweep& placed, const std::vector<Link>& links,
                     const std::vector<PlacedSweep>& map);

}  // namespace scanway
