// The paper's table on simulated outdoor sweeps of full size, and a whole pair from binary files to the verdict.
//   registration_paper table [--world yard ...] [--runs 5] [--thin 1]
//   registration_paper write FOLDER [--world hall] [--distance 10] [--slower 1.21]
//   registration_paper whole FOLDER [--runs 5]
#include <cstdio>
#include <filesystem>
#include <string>

#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include "tests/bench/registration/paper/paper_table.h"
#include "tests/bench/registration/paper/whole_pair.h"

int main(int argc, char** argv) {
  using namespace scanway::bench;
  CLI::App app{"Registration at full size"};
  app.require_subcommand(1);
  TableOptions table;
  std::string folder, world = "hall";
  double distance_m = 10.0, slower = 1.21;
  int runs = 5;
  CLI::App* table_command = app.add_subcommand("table", "10 m and 35 m apart, five runs each, one thread");
  table_command->add_option("--world", table.worlds, "One or more; their medians at the end");
  table_command->add_option("--runs", table.runs);
  table_command->add_option("--thin", table.thin, "Only every thin-th line and beam");
  CLI::App* write = app.add_subcommand("write", "A pair of full sweeps as binary files");
  write->add_option("folder", folder)->required();
  write->add_option("--world", world);
  write->add_option("--distance", distance_m);
  write->add_option("--slower", slower, "The pan's turning, for more lines: 1.21 gives 3.4 million points in the hall");
  CLI::App* whole = app.add_subcommand("whole", "From those files to the verdict");
  whole->add_option("folder", folder)->required();
  whole->add_option("--runs", runs);
  CLI11_PARSE(app, argc, argv);
  if (*table_command) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    print_paper_table(table);
  } else if (*write) {
    std::filesystem::create_directories(folder);
    write_whole_pair(folder, world, distance_m, slower);
  } else {
    run_whole_pair(folder, runs);
  }
}
