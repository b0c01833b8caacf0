#pragma once

#include <string>

namespace scanway::bench {

struct TableOptions {
  std::string world = "yard";
  int runs = 5;
  int thin = 1;
};

/// The paper's table: two outdoor cases, 10 m and 35 m apart, mean and deviation of the CPU seconds of the rough
/// registration (thinning, FPFH, matching, search) and of the refinement (surfaces, ICP, last step); every run is
/// another pair of sweeps. Prints the error against the truth beside them.
void print_paper_table(const TableOptions& options);

}  // namespace scanway::bench
