#include "modules/tools/plan/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <nlohmann/json.hpp>

#include "common/files/input_error.h"
#include "tests/support/command.h"

namespace scanway::test {
namespace {

using tools::PlanOptions;
using tools::run_plan;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A room of 4 m x 2 m at 0.05 m a cell, its origin at (-1, -1): a wall across at x = 1 m with a gap of `gap` cells
/// from y = 0 up, unknown pixels in the lowest rows.
class PlanTool : public testing::Test {
 protected:
  void write_room(int gap) {
    std::string pgm = "P5\n80 40\n255\n";
    for (int row = 0; row < 40; ++row) {
      const int y = 39 - row;
      for (int x = 0; x < 80; ++x) {
        const bool wall = (x == 40 || x == 41) && (y < 20 || y >= 20 + gap);
        pgm += wall ? '\0' : y < 4 ? '\xCD' : '\xFE';
      }
    }
    write_text(folder / "room.pgm", pgm);
    write_yaml("");
  }
  void write_yaml(const std::string& more, const std::string& origin = "[-1, -1, 0]") {
    write_text(folder / "room.yaml", "image: room.pgm\nresolution: 0.05\norigin: " + origin +
                                         "\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n" + more);
  }
  PlanOptions options() {
    PlanOptions options;
    options.map = folder / "room.yaml";
    options.start_m = {0.0, 0.3};
    options.goal_m = {2.3, 0.3};
    options.json = true;
    return options;
  }
  nlohmann::json answer(const PlanOptions& options) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(run_plan(options), 0);
    return nlohmann::json::parse(testing::internal::GetCapturedStdout());
  }
  void expect_refused(const PlanOptions& options, const std::string& word) {
    testing::internal::CaptureStdout();
    try {
      run_plan(options);
      ADD_FAILURE() << "not refused: " << word;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  }

  ScratchFolder folder;
};

TEST_F(PlanTool, AnswersInTheKeysThatAreFixed) {
  write_room(14);
  for (const char* mode : {"point", "paper", "footprint"}) {
    PlanOptions o = options();
    o.mode = mode;
    const nlohmann::json json = answer(o);
    EXPECT_EQ(json.size(), 14u);
    EXPECT_EQ(json.at("status"), "ok") << mode;
    EXPECT_EQ(json.at("unknown"), "never");
    EXPECT_GE(json.at("worst_cost"), 1.0);
    EXPECT_EQ(json.at("time_s").size(), json.at("path").size());
    EXPECT_EQ(json.at("speed_m_s").size(), json.at("path").size());
    EXPECT_EQ(json.at("duration_s"), json.at("time_s").back());
    EXPECT_NEAR(json.at("length_m"), 2.3, 0.5);
    EXPECT_GE(json.at("cost"), json.at("length_m").get<double>() - 1e-9);
    EXPECT_GT(json.at("clearance_m"), 0.0);
    EXPECT_EQ(json.at("unknown_share"), 0.0);
    EXPECT_GT(json.at("expansions"), 0);
    EXPECT_GT(json.at("seconds").at("total"), 0.0);
    const auto& path = json.at("path");
    EXPECT_EQ(path.front().size(), 3u);
    EXPECT_NEAR(path.front()[0], 0.0, 0.026);
    EXPECT_NEAR(path.back()[0], 2.3, 0.026);
  }
}

TEST_F(PlanTool, TheBodyNeedsTheGapThatThePointDoesNot) {
  write_room(7);
  PlanOptions o = options();
  EXPECT_NE(answer(o).at("status").get<std::string>().find("too narrow"), std::string::npos);
  o.mode = "point";
  EXPECT_EQ(answer(o).at("status"), "ok");
}

TEST_F(PlanTool, WalledInIsAnAnswer) {
  write_room(0);
  EXPECT_EQ(answer(options()).at("status"), "walled in");
}

TEST_F(PlanTool, AnUnknownGoalIsAnAnswerWithinTheWholePicture) {
  write_room(14);
  PlanOptions o = options();
  o.goal_m = {0.0, -0.97};
  EXPECT_EQ(answer(o).at("status"), "goal unknown");
  o.unknown = "free";
  o.mode = "point";
  EXPECT_EQ(answer(o).at("unknown"), "free");
  const nlohmann::json json = answer(o);
  EXPECT_EQ(json.at("status"), "ok");
  EXPECT_GT(json.at("unknown_share"), 0.0);
}

TEST_F(PlanTool, ASmoothPathIsNoLongerAndCostsTheSame) {
  write_room(14);
  for (const char* mode : {"point", "paper", "footprint"}) {
    PlanOptions o = options();
    o.mode = mode;
    o.start_m = {-0.6, -0.4};
    const nlohmann::json usual = answer(o);
    o.smooth = false;
    const nlohmann::json cells = answer(o);
    o.smooth = true;
    const nlohmann::json smooth = answer(o);
    EXPECT_EQ(smooth.at("cost"), cells.at("cost"));
    EXPECT_LT(smooth.at("path").size(), cells.at("path").size());
    EXPECT_LE(smooth.at("length_m"), cells.at("length_m").get<double>() + (std::string(mode) == "point" ? -0.01 : 0.3));
    EXPECT_EQ(usual.at("path"), std::string(mode) == "footprint" ? smooth.at("path") : cells.at("path")) << mode;
  }
}

TEST_F(PlanTool, ExplainsWhatIsInTheWay) {
  const auto explained = [&](const PlanOptions& o) { return answer(o).at("explanation"); };
  PlanOptions o = options();
  o.explain = true;
  write_room(14);
  EXPECT_NE(explained(o).at("text").get<std::string>().find("there is a path"), std::string::npos);
  o.goal_m = {1.02, 0.9};
  EXPECT_EQ(answer(o).at("status"), "goal in an obstacle");
  EXPECT_NE(explained(o).at("text").get<std::string>().find("in an obstacle"), std::string::npos);
  EXPECT_NEAR(explained(o).at("near_m")[1], 0.9, 0.3);
  o.goal_m = {0.0, -0.97};
  EXPECT_NE(explained(o).at("text").get<std::string>().find("nobody has seen the goal"), std::string::npos);
  o.goal_m = {0.93, -0.3};
  const nlohmann::json tight = explained(o);
  EXPECT_NEAR(tight.at("blocked_m"), 0.075, 0.03);
  EXPECT_NEAR(tight.at("needed_m"), 0.2, 1e-9);
  o = options();
  o.explain = true;
  write_room(7);
  const nlohmann::json narrow = explained(o);
  EXPECT_NEAR(narrow.at("width_m"), 0.35, 1e-9);
  EXPECT_NEAR(narrow.at("needed_m"), 0.40, 1e-9);
  EXPECT_NEAR(narrow.at("turning_m"), 2.0 * std::hypot(0.2, 0.205), 1e-9);
  EXPECT_NEAR(narrow.at("at_m")[0], 1.05, 0.06);
  EXPECT_NEAR(narrow.at("at_m")[1], 0.175, 0.06);
  write_room(0);
  const nlohmann::json walled = explained(o);
  EXPECT_NEAR(walled.at("reached_m2"), 2.0 * 2.0 + 0.0, 0.01);
  EXPECT_NEAR(walled.at("near_m")[0], 0.975, 1e-6);
}

TEST_F(PlanTool, WritesPathAndPicture) {
  write_room(14);
  PlanOptions o = options();
  o.output = folder / "out";
  const nlohmann::json json = answer(o);
  const std::string csv = read_text(folder / "out/path.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "x_m,y_m,heading_rad,time_s,speed_m_s");
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), json.at("path").size() + 1);
  EXPECT_EQ(read_text(folder / "out/path.png").substr(1, 3), "PNG");
}

TEST_F(PlanTool, RefusesBadInput) {
  write_room(14);
  const auto with_start = [&](double x, double y) {
    PlanOptions o = options();
    o.start_m = {x, y};
    return o;
  };
  expect_refused(with_start(1.02, 0.9), "--start");
  for (const double bad : {-1.01, 3.01, 1e300, -1e300, kNaN, HUGE_VAL})
    expect_refused(with_start(bad, 0.3), "off the map");
  PlanOptions o = options();
  o.goal_m = {1.02, 0.9};
  expect_refused(o, "in an obstacle");
  o = options();
  o.map = folder / "none.yaml";
  expect_refused(o, "none.yaml");
  write_yaml("", "[-1, -1, 0.3]");
  expect_refused(options(), "yaw");
  write_yaml("");
  EXPECT_EQ(answer(options()).at("status"), "ok");
  write_text(folder / "room.pgm", "P5\n80 40\n255\nshort");
  expect_refused(options(), "room.pgm");
}

}  // namespace
}  // namespace scanway::test
