#include "common/process/program.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <thread>

#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {
namespace {

constexpr int kBadInput = 2;
constexpr int kStartAgain = 3;
constexpr double kBytesPerMbit = 125e3;
/// When nothing new has come for so long, the bus is taken to be silent.
constexpr SteadyTime kSilence = 2 * kSteadySecond;
constexpr auto kWait = std::chrono::milliseconds(50);
constexpr auto kLastWords = std::chrono::milliseconds(1500);

volatile std::sig_atomic_t end_asked = 0;

void end_on_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { end_asked = 1; };
  action.sa_flags = SA_RESETHAND;  // Asked twice, it ends at once.
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void log_to_stderr(const std::string& name) {
  auto logger = spdlog::stderr_color_mt(name);
  logger->set_pattern("%^%n: %l%$: %v");
  spdlog::set_default_logger(logger);
}

int refuse(const std::string& name, const std::string& message) {
  std::fputs((name + ": " + printable(message) + "\n").c_str(), stderr);
  return kBadInput;
}

void add_options(CLI::App& app, ProgramOptions& options) {
  app.add_option("--robot", options.robot, "Robot file (default: ERA-Mobi)");
  app.add_option("--lcm-url", options.lcm_url, "The bus (default: LCM_DEFAULT_URL, or multicast on this machine)");
  app.add_option("--state", options.state, "Folder to keep what is needed after a restart");
  app.add_option("--rate-mbit-s", options.rate_mbit_s, "The most that large objects may take of the network")
      ->check(CLI::Range(0.1, 10000.0))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "Threads to compute with (default: as many as there are cores)")
      ->check(CLI::Range(1u, 256u));
}

}  // namespace

int run_main(const std::string& name, const std::string& purpose, int argc, char** argv,
             const std::function<void(CLI::App&)>& add_options, const std::function<int()>& work) {
  log_to_stderr(name);
  end_on_signals();
  CLI::App app{purpose};
  add_options(app);
  try {
    app.parse(argc, argv);
    return work();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return refuse(name, std::string(error.what()) + "; see " + name + " --help");
  } catch (const StartAgain& reason) {
    spdlog::info("starting again: {}", reason.what());
    return kStartAgain;
  } catch (const std::exception& error) {
    return refuse(name, error.what());
  }
}

int run_program(const std::string& name, const std::string& purpose, int argc, char** argv,
                const std::function<int(const ProgramOptions&)>& work, const std::function<void(CLI::App&)>& add_own) {
  ProgramOptions options;
  return run_main(
      name, purpose, argc, argv,
      [&](CLI::App& app) {
        add_options(app, options);
        if (add_own) add_own(app);
      },
      [&options, &work] {
        const tbb::global_control limit(
            tbb::global_control::max_allowed_parallelism,
            options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency()));
        return work(options);
      });
}

Robot robot_of(const std::string& file) { return file.empty() ? Robot{} : load_robot(file); }

LiveBusOptions live_bus_options(const ProgramOptions& options) {
  LiveBusOptions live;
  live.sender.bytes_per_second = options.rate_mbit_s * kBytesPerMbit;
  return live;
}

bool asked_to_end() { return end_asked != 0; }

void serve(LiveBus& bus, const NodeWork& work) {
  std::size_t known = work.news();
  SteadyTime last_news = steady_now(), next_second = 0;
  while (!asked_to_end()) {
    bus.dispatch(kWait);
    const SteadyTime now = steady_now();
    if (work.news() != known) {
      known = work.news();
      last_news = now;
    }
    if (now - last_news > kSilence) {
      work.settle();
      last_news = steady_now() - kSilence / 2;  // Again in a second.
    }
    if (now >= next_second) {
      work.every_second();
      next_second = now + kSteadySecond;
    }
  }
  bus.drain(kLastWords);
}

}  // namespace scanway
