#pragma once

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>

#include "common/delivery/live_bus.h"
#include "common/robot/robot.h"

namespace CLI {
class App;
}

namespace scanway {

/// What every program of the bus is told on its command line.
struct ProgramOptions {
  std::string robot;    ///< Robot file; empty: the built-in ERA-Mobi.
  std::string lcm_url;  ///< Empty: LCM_DEFAULT_URL, or LCM's default.
  std::string state;    ///< Folder to keep what is needed after a restart; empty: nothing is kept.
  double rate_mbit_s = 32.0;
  unsigned threads = 0;  ///< 0: as many as there are cores.
};

/// Thrown by a process that must be started again to go on. what() says why, in one line.
class StartAgain : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// main() of a program: reads the command line, runs `work`, and makes one line of what goes wrong (status 2;
/// StartAgain: status 3). INT and TERM ask it to end.
int run_main(const std::string& name, const std::string& purpose, int argc, char** argv,
             const std::function<void(CLI::App&)>& add_options, const std::function<int()>& work);

/// main() of a program of the bus that computes. `add_own`: options of its own.
int run_program(const std::string& name, const std::string& purpose, int argc, char** argv,
                const std::function<int(const ProgramOptions&)>& work,
                const std::function<void(CLI::App&)>& add_own = {});

/// The robot of the file that the options (of a program or a bridge) name.
Robot robot_of(const std::string& file);
inline Robot robot_of(const ProgramOptions& options) { return robot_of(options.robot); }
LiveBusOptions live_bus_options(const ProgramOptions& options);

/// Whether INT or TERM asked the process to end.
bool asked_to_end();

/// What a program does for its node, all in the node's thread.
struct NodeWork {
  std::function<std::size_t()> news;  ///< How many inputs the node has taken so far.
  std::function<void()> settle;       ///< Nothing new has come for a while.
  std::function<void()> every_second;
};

/// Lets a node work on what comes until the process is asked to end.
void serve(LiveBus& bus, const NodeWork& work);

}  // namespace scanway
