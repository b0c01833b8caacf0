// What people get wrong, and the same done right: each with its one line, exit status 2, and nothing left behind.

#include <filesystem>

#include "tests/end_to_end/scanway.h"

namespace scanway::test {
namespace {

std::string pcd(const std::vector<std::string>& points) {
  std::string text = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
                     std::to_string(points.size()) + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
                     std::to_string(points.size()) + "\nDATA ascii\n";
  for (const std::string& point : points) text += point + "\n";
  return text;
}

class Import : public testing::Test {
 protected:
  CommandResult import(const std::string& text, const std::string& name = "scan.pcd") {
    write_text(folder / name, text);
    return run_scanway({"import", "clouds", folder / name, "-o", folder / "out.lcmlog"});
  }
  bool log_is_there() const { return std::filesystem::exists(folder / "out.lcmlog"); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder.path()), {}));
  }
  ScratchFolder folder;
};

TEST_F(Import, TakesAScan) {
  const CommandResult result = import(pcd({"1 0 0", "0 1 0", "2 1 0", "0 0 1"}));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(log_is_there());
}

TEST_F(Import, TakesAScanWithSomePointsThatAreNotFinite) {
  const CommandResult result = import(pcd({"1 0 0", "nan nan nan", "0 1 0", "2 1 0", "0 0 1"}));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("1 point"), std::string::npos) << "it says what it left out: " << result.err;
}

TEST_F(Import, RefusesAnEmptyCloud) {
  expect_refused(import(pcd({})), "scan.pcd");
  EXPECT_EQ(files(), 1u);
}

TEST_F(Import, RefusesPointsOfWhichNoneIsFinite) {
  expect_refused(import(pcd({"nan nan nan", "inf 0 0", "nan 1 1"})), "finite");
  EXPECT_EQ(files(), 1u);
}

TEST_F(Import, RefusesOnePoint) {
  expect_refused(import(pcd({"1 2 3"})), "1 point");
  EXPECT_EQ(files(), 1u);
}

TEST_F(Import, RefusesAFileThatIsNoCloud) {
  expect_refused(import("\x1b[2J no cloud\n"), "scan.pcd");
  expect_refused(import("what", "scan\x1b[31m.pcd"), "scan\\x1B[31m.pcd");
}

TEST_F(Import, RefusesPosesWithALineMissing) {
  const std::string all = read_text(hall_poses());
  write_text(folder / "poses.txt", all.substr(0, all.find("scan001")));
  const auto words = [&](const std::string& scan) {
    return std::vector<std::string>{
        "import", "clouds", hall(scan), "--poses", folder / "poses.txt", "-o", folder / "out.lcmlog"};
  };
  expect_refused(run_scanway(words("scan001.pcd")), "scan001");
  EXPECT_FALSE(log_is_there());
  EXPECT_EQ(run_scanway(words("scan000.pcd")).status, 0);
}

TEST_F(Import, RefusesAnUnknownKeyOrAWrongUnitInTheRobotFile) {
  write_text(folder / "scan.pcd", pcd({"1 0 0", "0 1 0", "2 1 0"}));
  const auto with_robot = [&](const std::string& text) {
    write_text(folder / "robot.yaml", text);
    return run_scanway(
        {"import", "clouds", folder / "scan.pcd", "--robot", folder / "robot.yaml", "-o", folder / "out.lcmlog"});
  };
  expect_refused(with_robot("schema: 1\nbody:\n  hight_m: 1.5\n"), "height_m");
  expect_refused(with_robot("schema: 1\nbody:\n  height_cm: 150\n"), "height_m");
  EXPECT_FALSE(log_is_there());
  EXPECT_EQ(with_robot("schema: 1\nbody:\n  height_m: 1.5\n").status, 0);
}

TEST_F(Import, RefusesAnOutputFolderThatCannotBeWritten) {
  write_text(folder / "scan.pcd", pcd({"1 0 0", "0 1 0", "2 1 0"}));
  write_text(folder / "file", "");
  expect_refused(run_scanway({"import", "clouds", folder / "scan.pcd", "-o", folder / "file/out.lcmlog"}), "file");
}

TEST(Register, RefusesOnePointAndNoPoint) {
  const ScratchFolder folder;
  write_text(folder / "one.pcd", pcd({"1 2 3"}));
  write_text(folder / "none.pcd", pcd({}));
  expect_refused(run_scanway({"register", folder / "one.pcd", hall("scan000.pcd")}), "one.pcd");
  expect_refused(run_scanway({"register", hall("scan000.pcd"), folder / "none.pcd", "--json"}), "none.pcd");
  expect_refused(run_scanway({"register", hall("scan000.pcd"), folder / "missing.pcd"}), "missing.pcd");
  expect_refused(run_scanway({"register", hall("scan000.pcd"), hall("scan001.pcd"), "--orientation", "0,0,0,0"}),
                 "--orientation");
}

/// A map of 40 x 40 cells of 5 cm: free, but for a wall across it at x = 1 m that a door of 0.6 m leaves open.
class Plan : public testing::Test {
 protected:
  void SetUp() override {
    std::string image = "P5\n40 40\n255\n";
    for (int row = 0; row < 40; ++row) {
      for (int column = 0; column < 40; ++column) image += column == 20 && (row < 14 || row > 25) ? '\0' : '\xfe';
    }
    write_text(folder / "map.pgm", image);
    write_text(folder / "map.yaml",
               "image: map.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\n"
               "free_thresh: 0.196\n");
  }
  CommandResult plan(const std::string& start, const std::string& goal) {
    return run_scanway({"plan", folder / "map.yaml", "--start", start, "--goal", goal, "--json"});
  }
  ScratchFolder folder;
};

TEST_F(Plan, FindsThePath) {
  const CommandResult result = plan("0.5,1.0", "1.5,1.0");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out.front(), '{');
  EXPECT_NE(result.out.find("\"status\": \"ok\""), std::string::npos) << result.out;
}

TEST_F(Plan, RefusesAStartOrGoalInAnObstacle) {
  expect_refused(plan("1.02,0.2", "1.5,1.0"), "start");
  expect_refused(plan("0.5,1.0", "1.02,0.2"), "goal");
}

TEST_F(Plan, RefusesAStartOrGoalOffTheMap) {
  expect_refused(plan("-3.5,1.0", "1.5,1.0"), "start");
  expect_refused(plan("0.5,1.0", "1.5,1e300"), "goal");
  expect_refused(plan("0.5,1.0", "nan,1.0"), "goal");
}

TEST_F(Plan, RefusesWordsThatItDoesNotKnow) {
  expect_refused(plan("0.5;1.0", "1.5,1.0"), "--start");
  expect_refused(run_scanway({"plan", folder / "map.yaml", "--start", "1,1", "--goal", "1,1", "--mode", "car"}),
                 "--mode");
  expect_refused(run_scanway({"fly"}), "scanway");
}

}  // namespace
}  // namespace scanway::test
