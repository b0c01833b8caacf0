// A log of real scans through the whole chain: the poses are right, the bytes are the same every time, and a damaged
// log is said to be one.

#include <filesystem>

#include <nlohmann/json.hpp>

#include "tests/end_to_end/scanway.h"

namespace scanway::test {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> kProducts = {"out.lcmlog",     "map.pcd",     "map.ply",      "map.bt",
                                            "map.ot",         "costmap.pgm", "costmap.yaml", "path.csv",
                                            "trajectory.tum", "map.png",     "costmap.png",  "path.png"};

/// One log and its replay, made once for all tests of this file.
class Replay : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    const CommandResult imported = run_scanway(import_halls({"scan000.pcd", "scan001.pcd"}, log()));
    ASSERT_EQ(imported.status, 0) << imported.err;
    first_ = new CommandResult(replay(log(), "first", "2"));
    ASSERT_EQ(first_->status, 0) << first_->err;
  }
  static void TearDownTestSuite() {
    delete first_;
    delete folder_;
  }

  static std::string path(const std::string& name) { return *folder_ / name; }
  static std::string log() { return path("halls.lcmlog"); }
  static CommandResult replay(const std::string& log, const std::string& name, const std::string& threads) {
    return run_scanway({"replay", log, "-o", path(name), "--threads", threads});
  }
  static Json report(const std::string& name) { return Json::parse(read_text(path(name) + "/report.json")); }

  static ScratchFolder* folder_;
  static CommandResult* first_;
};
ScratchFolder* Replay::folder_ = nullptr;
CommandResult* Replay::first_ = nullptr;

TEST_F(Replay, WritesEveryProductAndItsTable) {
  for (const std::string& product : kProducts) {
    EXPECT_GT(std::filesystem::file_size(path("first/" + product)), 0u) << product;
  }
  EXPECT_NE(first_->out.find("scan001"), std::string::npos) << first_->out;
  EXPECT_EQ(first_->err, "") << "nothing to complain about";
}

TEST_F(Replay, ReportsScansNearTheirReference) {
  const Json result = report("first");
  ASSERT_EQ(result["scans"].size(), 2u);
  EXPECT_EQ(result["scans"][1]["name"], "scan001");
  EXPECT_EQ(result["scans"][1]["verdict"], "accepted");
  EXPECT_EQ(result["scans"][1]["T_map_scan"].size(), 16u);
  EXPECT_LT(result["scans"][1]["error_m"], 0.05);
  EXPECT_LT(result["scans"][1]["error_deg"], 0.3);
  for (const char* key : {"map", "octomap", "costmap", "path"}) {
    EXPECT_EQ(result["digests"][key].get<std::string>().size(), 16u) << key;
  }
  EXPECT_EQ(result["paths"]["with_embodiment"]["status"], "ok");
  EXPECT_GE(result["paths"]["with_embodiment"]["cost"], result["paths"]["without_embodiment"]["cost"]);
}

TEST_F(Replay, GivesTheSameBytesForEveryNumberOfThreads) {
  for (const char* threads : {"1", "3"}) {
    ASSERT_EQ(replay(log(), threads, threads).status, 0);
    for (const std::string& product : kProducts) {
      EXPECT_EQ(read_text(path("first/" + product)), read_text(path(threads + ("/" + product))))
          << product << " differs between 2 and " << threads << " threads";
    }
    EXPECT_EQ(report("first")["digests"], report(threads)["digests"]);
  }
}

TEST_F(Replay, WorksOnTheGoodPartOfALogThatIsCut) {
  const std::string whole = read_text(log());
  // In the second scan: the first is all there.
  write_text(path("cut.lcmlog"), whole.substr(0, whole.size() * 7 / 10));
  const CommandResult result = replay(path("cut.lcmlog"), "cut", "2");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("cut"), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << "one line: " << result.err;
  EXPECT_EQ(report("cut")["scans"].size(), 1u);
  EXPECT_EQ(run_scanway({"info", path("cut.lcmlog")}).status, 1);
  EXPECT_EQ(run_scanway({"info", log()}).status, 0);
}

TEST_F(Replay, SaysSomethingAboutALogThatIsCutAnywhere) {
  const std::string whole = read_text(log());
  for (const std::size_t length : {1u, 27u, 28u, 60u, 700u, 1500u}) {
    const std::string name = "cut" + std::to_string(length);
    write_text(path(name + ".lcmlog"), whole.substr(0, length));
    const CommandResult result = replay(path(name + ".lcmlog"), name, "1");
    EXPECT_TRUE(result.status == 1 || result.status == 2) << length << ": " << result.status;
    EXPECT_NE(result.err.find(name), std::string::npos) << length << ": " << result.err;
  }
}

TEST_F(Replay, IsVerifiedByWhatItsOwnLogHolds) {
  const std::string products = path("first/out.lcmlog");
  const CommandResult equal = run_scanway({"replay", "--verify", products});
  EXPECT_EQ(equal.status, 0) << equal.out;
  EXPECT_EQ(equal.out, "");
  EXPECT_TRUE(equal.err.starts_with("verified: ")) << equal.err;
  EXPECT_EQ(run_scanway({"replay", "--verify", log()}).status, 3) << "no product in it";

  std::string bytes = read_text(products);
  bytes[bytes.find("OCTOMAP") + 400] ^= 1;  // In the data of its first piece.
  write_text(path("altered.lcmlog"), bytes);
  const CommandResult altered = run_scanway({"replay", "--verify", path("altered.lcmlog")});
  EXPECT_EQ(altered.status, 1);
  EXPECT_TRUE(altered.out.starts_with("different: OCTOMAP map version 1: ")) << altered.out;
}

TEST_F(Replay, WithAnotherRobotThatIsTheConfigurationInItsLog) {
  write_text(path("paper.yaml"), "mapping:\n  embodiment: paper\n");
  ASSERT_EQ(run_scanway({"replay", log(), "-o", path("other"), "--robot", path("paper.yaml")}).status, 0);
  const CommandResult verified = run_scanway({"replay", "--verify", path("other/out.lcmlog")});
  EXPECT_EQ(verified.status, 0) << verified.out;
  EXPECT_NE(report("other")["digests"], report("first")["digests"]);
}

TEST_F(Replay, WantsAFolderOrToVerify) {
  expect_refused(run_scanway({"replay", log()}), "--output or --verify");
  expect_refused(run_scanway({"replay", log(), "--verify", "-o", path("none")}), "excludes");
}

TEST_F(Replay, RefusesWhatIsNoLog) {
  write_text(path("text.lcmlog"), "This is no log.\n");
  expect_refused(replay(path("text.lcmlog"), "none", "1"), "text.lcmlog");
  EXPECT_FALSE(std::filesystem::exists(path("none")));
  expect_refused(replay(path("missing.lcmlog"), "none", "1"), "missing.lcmlog");
}

TEST_F(Replay, RefusesAFolderThatCannotBeWritten) {
  write_text(path("file"), "");
  expect_refused(replay(log(), "file/products", "1"), "file");
}

}  // namespace
}  // namespace scanway::test
