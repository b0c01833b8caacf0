#pragma once

namespace scanway::bench {

/// Prints a table: the costs of 4000 x 4000 cells of which 5 % are occupied, by a direct table and by ours, whole and
/// where one tile changes, CPU milliseconds on one thread.
void compare_embodiments();

}  // namespace scanway::bench
