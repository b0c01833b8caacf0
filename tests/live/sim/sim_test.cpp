// A thinned run of launch/sim: all processes, drives and sweeps on command, one map, and its errors.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "common/clock/steady_time.h"
#include "tests/live/sim/support/simulated_run.h"
#include "tests/support/program.h"

namespace scanway::test {
namespace {

TEST(LaunchSim, AThinnedRunOfThreePlacesIsOneMap) {
  const SimulatedRun run({"--thin", "4", "--places", "3", "--speed", "20"});
  ASSERT_EQ(run.said().status, 0) << run.told();
  EXPECT_EQ(run.pictures().size(), 3U) << run.said().out;
  const auto truth = run.truth();
  ASSERT_EQ(truth["sweeps"].size(), 3U);
  for (const auto& sweep : truth["sweeps"]) {
    ASSERT_EQ(sweep["verdict"], "accepted") << run.said().out;
    EXPECT_LT(sweep["to_previous_error_m"], 0.05) << run.said().out;
    EXPECT_LT(sweep["to_previous_error_deg"], 0.3) << run.said().out;
  }
}

/// How many processes have that text in their environment.
int processes_with(const std::string& mark) {
  int count = 0;
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    std::ifstream environment(process.path() / "environ", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(environment), {}};
    if (text.find(mark) != std::string::npos) ++count;
  }
  return count;
}

class LaunchSimEnds : public testing::TestWithParam<int> {};

TEST_P(LaunchSimEnds, WithAllThatItStarted) {
  const ScratchFolder folder;
  const std::string mark = "SCANWAY_TEST_MARK=" + folder.path();
  Program sim({"env", mark, "SCANWAY_BUILD=" + SimulatedRun::build(), SimulatedRun::script(), "--thin", "8", "-o",
               folder.path()},
              folder / "out", folder / "err");
  const auto till = [](SteadyTime patience, const auto& done) {
    for (const SteadyTime end = steady_now() + patience; !done() && steady_now() < end;) usleep(20'000);
    return done();
  };
  const std::string words = folder / "processes.txt";
  ASSERT_TRUE(till(60'000'000, [&] {
    return std::filesystem::exists(words) && read_text(words).find("scanway-mapper: info: ready") != std::string::npos;
  })) << read_text(folder / "err");
  EXPECT_GT(processes_with(mark), 9) << "seven programs, their keepers, the logger";
  EXPECT_NE(sim.end(GetParam()), 0);
  EXPECT_TRUE(till(20'000'000, [&] { return processes_with(mark) == 0; })) << processes_with(mark);
}

INSTANTIATE_TEST_SUITE_P(Signals, LaunchSimEnds, testing::Values(SIGINT, SIGKILL));

TEST(LaunchSim, RefusesWhatItDoesNotKnowInOneLine) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--speed", "fast"}, {"--places", "0"}, {"--frobnicate"}, {"--thin"}}) {
    const SimulatedRun run(options);
    EXPECT_EQ(run.said().status, 2);
    EXPECT_EQ(run.said().out, "");
    EXPECT_EQ(std::count(run.said().err.begin(), run.said().err.end(), '\n'), 1) << run.said().err;
  }
}

}  // namespace
}  // namespace scanway::test
