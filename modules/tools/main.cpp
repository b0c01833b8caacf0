/// `scanway`: reads the command line, runs the chosen subcommand, and says in one line what went wrong.

#include <cstdio>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "modules/tools/arguments/arguments.h"

namespace scanway::tools {
namespace {

constexpr int kBadInput = 2;

void log_to_stderr() {
  auto logger = spdlog::stderr_color_st("scanway");
  logger->set_pattern("scanway: %v");
  spdlog::set_default_logger(logger);
}

/// The error's one line, and the exit status for bad input.
int refuse(const std::string& message) {
  std::fputs(fmt::format("scanway: {}\n", printable(message)).c_str(), stderr);
  return kBadInput;
}

int run(int argc, char** argv) {
  CLI::App app{"Scanway: registered maps and paths from the 3D scans of a stop-and-scan robot"};
  app.require_subcommand(1);
  app.fallthrough();
  unsigned threads = 0;
  app.add_option("--threads", threads, "Threads to compute with (default: as many as there are cores)")
      ->check(CLI::Range(1u, 256u));
  Action action;
  add_import(app, action);
  add_register(app, action);
  add_plan(app, action);
  add_octomap(app, action);
  add_replay(app, action);
  add_info(app, action);
  add_spy(app, action);
  add_simulate(app, action);
  add_command(app, action);
  add_drive(app, action);
  add_decode(app, action);
  add_map(app, action);
  add_export(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return refuse(fmt::format("{}; see scanway --help", error.what()));
  }
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency()));
  return action();
}

}  // namespace
}  // namespace scanway::tools

int main(int argc, char** argv) {
  scanway::tools::log_to_stderr();
  try {
    return scanway::tools::run(argc, argv);
  } catch (const scanway::InputError& error) {
    return scanway::tools::refuse(error.what());
  } catch (const std::bad_alloc&) {
    return scanway::tools::refuse("not enough memory for this input");
  } catch (const std::exception& error) {
    return scanway::tools::refuse(error.what());
  }
}
