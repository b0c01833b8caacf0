#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/files/input_error.h"
#include "modules/tools/plan/moving_ai.h"
#include "modules/tools/plan/plan_scenario.h"
#include "tests/support/command.h"

namespace scanway::test {
namespace {

/// A wall with a way round it at the right; a corner must not be cut.
class PlanScenario : public testing::Test {
 protected:
  void write_map(const std::string& rows = "......\n.@@@@.\n......\n@T.S.W\n", int height = 4) {
    write_text(folder / "small.map", "type octile\nheight " + std::to_string(height) + "\nwidth 6\nmap\n" + rows);
  }
  void write_problems(const std::string& lines, const std::string& head = "version 1\n") {
    write_text(folder / "small.map.scen", head + lines);
  }
  std::string scenario() const { return folder / "small.map.scen"; }
  nlohmann::json answer(int status) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(tools::run_plan_scenario({scenario(), true}), status);
    return nlohmann::json::parse(testing::internal::GetCapturedStdout());
  }
  void expect_refused(const std::string& word) {
    try {
      tools::run_plan_scenario({scenario(), true});
      ADD_FAILURE() << "not refused: " << word;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
  ScratchFolder folder;
};

TEST_F(PlanScenario, CountsTheOptimalOnes) {
  write_map();
  write_problems(
      "0\tsmall.map\t6\t4\t0\t0\t0\t2\t2\n"
      "1\tsmall.map\t6\t4\t3\t0\t3\t2\t6\n"  // 2 right, 2 down, 2 left: no corner is cut
      "1\tsmall.map\t6\t4\t2\t2\t3\t3\t1.41421356\n"
      "1\tsmall.map\t6\t4\t0\t0\t0\t2\t2.5\n"
      "1\tsmall.map\t6\t4\t0\t0\t5\t3\t9\n");
  const nlohmann::json json = answer(1);
  EXPECT_EQ(json["problems"], 5);
  EXPECT_EQ(json["optimal"], 3);
  EXPECT_EQ(json["unsolved"], 1) << "water is no way";
  EXPECT_NEAR(json["worst_error"].get<double>(), 0.5, 1e-9);
  EXPECT_GE(json["seconds"].get<double>(), 0.0);
}

TEST_F(PlanScenario, RefusesWhatIsNoScenario) {
  write_map();
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"0 small.map 6 4 0 0 6 0 1\n", "line 2: the goal's x"},
      {"0 small.map 12 8 0 0 1 1 1\n", "scaled"},
      {"0 small.map 6 4 0 0 1\n", "goal's y"},
      {"0 small.map 6 4 0 0 1 1 nan\n", "optimal length"},
      {"x small.map 6 4 0 0 1 1 1\n", "bucket"},
      {"0 other.map 6 4 0 0 1 1 1\n", "other.map"},
      {"", "no problem"},
  };
  for (const auto& [lines, word] : cases) {
    write_problems(lines);
    expect_refused(word);
  }
  write_problems("0 small.map 6 4 0 0 1 1 1\n", "");
  expect_refused("version 1");
  write_problems("0 small.map 6 4 0 0 1 1 1\n");
  write_map("......\n", 4);
  expect_refused("small.map: line 5: ");
  write_map("......\n.....\n......\n......\n");
  expect_refused("5 cells");
}

TEST_F(PlanScenario, MovingAisArena) {
  const std::string arena = SCANWAY_SHARED_DIR "/data/grid_maps_movingai/arena.map.scen";
  if (!std::filesystem::exists(arena)) GTEST_SKIP() << "no ../shared/data/grid_maps_movingai";
  testing::internal::CaptureStdout();
  EXPECT_EQ(tools::run_plan_scenario({arena, true}), 0);
  const auto json = nlohmann::json::parse(testing::internal::GetCapturedStdout());
  EXPECT_EQ(json["problems"], 160);
  EXPECT_EQ(json["optimal"], 160);
}

}  // namespace
}  // namespace scanway::test
