// Mapper and planner on two pretend machines, with frames lost and links cut between them.
#include <gtest/gtest.h>

#include "tests/live/support/session.h"

namespace scanway::test {
namespace {

class TwoMachines : public testing::Test {
 protected:
  void SetUp() override {
    if (!namespaces_permitted()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  }
  // Of what has versions: the newest.
  static std::string newest(const std::string& lines) {
    const std::size_t end = lines.find_last_not_of('\n');
    return end == std::string::npos ? "" : lines.substr(lines.rfind('\n', end) + 1);
  }
  void expect_same_end_as_replay() {
    for (const char* product : {"COST_MAP_INDEX index", "OCTOMAP map", "PATH point", "PATH footprint"}) {
      EXPECT_EQ(newest(session_.observed(product)), newest(lines_of(ShortLog::get().products, product))) << product;
    }
    EXPECT_EQ(session_.observed("COST_MAP_TILE"), lines_of(ShortLog::get().products, "COST_MAP_TILE"));
    if (HasFailure()) std::puts(session_.told().c_str());
  }
  CommandResult run_on_two_machines(const std::vector<std::string>& options, const std::string& meanwhile = "") {
    return session_.run_on_lan(options, {R"(
    begin mapper
    touch "$LAN_DIR/mapper-ready"
    while [ ! -e "$LAN_DIR/planner-ready" ]; do sleep 0.1; done
    lcm-logplayer -s 4 "$LOG"
    wait $pid_mapper)",
                                         R"(
    while [ ! -e "$LAN_DIR/mapper-ready" ]; do sleep 0.1; done
    begin planner
    "$BIN/scanway-live-tool" observe "$LCM_DEFAULT_URL" 2 150 >"$WORK/observed.txt" 2>"$WORK/observer.err" &
    pid_observer=$!
    lcm-logplayer -s 4 -e GOAL "$LOG"  # The operator is on this side: a goal is said once, and nobody repeats it.
    touch "$LAN_DIR/planner-ready"
    )" + meanwhile + "\nfinish"});
  }
  const Session session_;
};

class Loss : public TwoMachines, public testing::WithParamInterface<int> {};

TEST_P(Loss, IsRepairedAndAddsUp) {
  const auto played = run_on_two_machines({"-t", "300", "-l", std::to_string(GetParam())});
  if (played.status == 125) GTEST_SKIP() << "no pretend LAN here: " << played.err;
  EXPECT_EQ(played.status, 0) << played.err << session_.told();
  expect_same_end_as_replay();
  const auto planner = session_.counters("planner"), mapper = session_.counters("mapper");
  std::puts(lines_of(session_.text("observed.txt"), "SECONDS").c_str());
  EXPECT_GT(planner.at("repaired"), 0);
  EXPECT_GE(mapper.at("pieces_resent"), planner.at("repaired"));
  EXPECT_EQ(planner.at("lacking"), 0);
  EXPECT_EQ(planner.at("given_up"), 0);
}

INSTANTIATE_TEST_SUITE_P(Percent, Loss, testing::Values(1, 5), testing::PrintToStringParamName());

TEST_F(TwoMachines, ALinkThatIsCutForTwentySecondsIsMadeUpFor) {
  const auto played = run_on_two_machines({"-t", "300"}, R"(
    sleep 5
    ip link set eth0 down
    sleep 20
    ip link set eth0 up
    ip route add 224.0.0.0/4 dev eth0)");
  if (played.status == 125) GTEST_SKIP() << "no pretend LAN here: " << played.err;
  EXPECT_EQ(played.status, 0) << played.err << session_.told();
  expect_same_end_as_replay();
}

}  // namespace
}  // namespace scanway::test
