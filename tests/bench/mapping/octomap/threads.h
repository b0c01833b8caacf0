#pragma once

namespace scanway::bench {

/// Prints a table: a full sweep of the yard into an OctoMap at 5 cm by stage, wall seconds on one thread and on two.
void compare_threads();

}  // namespace scanway::bench
