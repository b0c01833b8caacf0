#pragma once

#include <string>
#include <vector>

namespace scanway::bench {

struct TableOptions {
  std::vector<std::string> worlds = {"yard"};
  int runs = 5;
  int thin = 1;
};

/// The paper's table: 10 m and 35 m apart, mean and deviation of the CPU seconds of the rough registration (thinning,
/// FPFH, matching, search) and of the refinement (surfaces, ICP, last step); every run is another pair of sweeps.
/// Prints the error against the truth beside them, and of several worlds all together at the end. A world whose route
/// has no two places so far apart is left out.
void print_paper_table(const TableOptions& options);

}  // namespace scanway::bench
