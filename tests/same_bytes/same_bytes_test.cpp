// Contract 1 at length: the same log gives the same bytes, again and again, for every number of threads, in the build
// for debugging, and on a processor without FMA and AVX2.

#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/end_to_end/scanway.h"

namespace scanway::test {
namespace {

const std::vector<std::string> kCompared = {"out.lcmlog",  "map.pcd",  "map.ot",        "map.bt",
                                            "costmap.pgm", "path.csv", "trajectory.tum"};

class SameBytes : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    ASSERT_EQ(run_scanway(import_halls({"scan000.pcd", "scan001.pcd"}, log())).status, 0);
    ASSERT_EQ(run_scanway({"replay", log(), "-o", *folder_ / "expected"}).status, 0);
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string log() { return *folder_ / "halls.lcmlog"; }

  /// Replays with `program` (words that come before `replay`) and compares every product with the expected one.
  static void expect_same(std::vector<std::string> program, const std::string& threads,
                          const std::vector<std::string>& environment = {}) {
    const std::string out = *folder_ / "again";
    for (const std::string& word :
         {std::string("replay"), log(), std::string("-o"), out, std::string("--threads"), threads}) {
      program.push_back(word);
    }
    const CommandResult result = run_command(program, environment);
    ASSERT_EQ(result.status, 0) << result.err;
    for (const std::string& product : kCompared) {
      EXPECT_EQ(read_text(*folder_ / ("expected/" + product)), read_text(out + "/" + product))
          << product << " with " << threads << " threads";
    }
  }

  static std::string scanway() { return std::string(SCANWAY_BIN_DIR) + "/scanway"; }
  static ScratchFolder* folder_;
};
ScratchFolder* SameBytes::folder_ = nullptr;

constexpr int kRepetitions = 10;

TEST_F(SameBytes, AgainAndAgainForEveryNumberOfThreads) {
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    for (const char* threads : {"1", "2", "3"}) expect_same({scanway()}, threads);
  }
}

TEST_F(SameBytes, InTheBuildForDebugging) {
  const char* dev = std::getenv("SCANWAY_DEV_BUILD");
  if (dev == nullptr) GTEST_SKIP() << "SCANWAY_DEV_BUILD names no build folder of the preset dev; tests/run --all does";
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    for (const char* threads : {"1", "2", "3"}) expect_same({std::string(dev) + "/bin/scanway"}, threads);
  }
}

TEST_F(SameBytes, WithFmaAndAvx2HiddenFromTheCLibrary) {
  expect_same({scanway()}, "2", {"GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX,-AVX512F"});
}

TEST_F(SameBytes, OnAProcessorWithoutFmaAndAvx2) { expect_same({"qemu-x86_64", "-cpu", "Nehalem-v1", scanway()}, "2"); }

}  // namespace
}  // namespace scanway::test
