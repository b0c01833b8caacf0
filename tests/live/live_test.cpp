// Mapper and planner as processes of their own, on a bus that no packet leaves: what they make of a log that LCM's own
// player sends them is what replay makes of it in one process.
#include <gtest/gtest.h>

#include "tests/live/support/session.h"

namespace scanway::test {
namespace {

class Live : public testing::Test {
 protected:
  void SetUp() override {
    if (!namespaces_permitted()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  }
  void expect_same_as_replay() {
    EXPECT_EQ(session_.observed("COST_MAP_INDEX"), lines_of(ShortLog::get().products, "COST_MAP_INDEX"));
    EXPECT_EQ(session_.observed("OCTOMAP"), lines_of(ShortLog::get().products, "OCTOMAP"));
    EXPECT_EQ(session_.observed("PATH"), lines_of(ShortLog::get().products, "PATH"));
    EXPECT_EQ(session_.observed(), lines_of(ShortLog::get().products, ""));
    if (HasFailure()) std::puts(session_.told().c_str());
  }
  const Session session_;
};

TEST_F(Live, ALogPlayedIntoProcessesGivesWhatReplayGives) {
  const auto played = session_.run(R"(
    begin mapper
    begin planner
    observe 2 120
    record "$WORK/recorded.lcmlog"
    lcm-logplayer -s 4 "$LOG" || exit 1
    finish || exit 1
    end_record || exit 1
    "$BIN/scanway" replay --verify "$WORK/recorded.lcmlog" >"$WORK/verified.txt" 2>"$WORK/remarks.txt" || exit 1
    "$BIN/scanway" info "$WORK/recorded.lcmlog" >"$WORK/info.txt"
    "$BIN/scanway" replay "$WORK/recorded.lcmlog" -o "$WORK/replayed" >/dev/null || exit 1
    "$BIN/scanway-live-tool" digests "$WORK/replayed/out.lcmlog" >"$WORK/replayed.txt")");
  EXPECT_EQ(played.status, 0) << played.err << session_.told() << session_.text("verified.txt");
  expect_same_as_replay();
  EXPECT_EQ(session_.counters("planner").at("planner_map_behind"), 0);
  EXPECT_EQ(session_.counters("mapper").at("bad_messages"), 0);
  // What lcm-logger recorded of the session is what its inputs give, and replays to the same.
  EXPECT_EQ(session_.text("verified.txt"), "");
  EXPECT_NE(session_.text("remarks.txt").find("verified: "), std::string::npos) << session_.text("remarks.txt");
  EXPECT_NE(session_.text("info.txt").find("\nTIMING "), std::string::npos);
  EXPECT_EQ(lines_of(session_.text("replayed.txt"), ""), lines_of(ShortLog::get().products, ""));
}

TEST_F(Live, AnOperatorKeepsTheMapAndWithdrawsASweepAndTheLogIsVerified) {
  const auto played = session_.run(R"(
    begin mapper --maps "$WORK/maps"
    begin planner
    observe 2 120
    record "$WORK/recorded.lcmlog"
    lcm-logplayer -s 4 "$LOG" || exit 1
    wait $pid_observer || exit 1
    order() { "$BIN/scanway" map "$@" >>"$WORK/orders.txt" 2>&1; echo "$?" >>"$WORK/orders.txt"; }
    order keep both
    order withdraw scan001
    order withdraw scan001
    order keep one
    order keep ../elsewhere
    sleep 3
    end_record || exit 1
    kill -TERM $pid_mapper $pid_planner
    wait $pid_mapper $pid_planner
    "$BIN/scanway" map check "$WORK/maps/both" >/dev/null || exit 1
    "$BIN/scanway" map save "$WORK/maps/one" -o "$WORK/loaded" >/dev/null || exit 1
    for product in map.pcd map.ot costmap.pgm trajectory.tum; do
      cmp "$WORK/maps/one/$product" "$WORK/loaded/$product" >&2 || exit 1
    done
    "$BIN/scanway" replay --verify "$WORK/recorded.lcmlog" >"$WORK/verified.txt" 2>"$WORK/remarks.txt")");
  EXPECT_EQ(played.status, 0) << played.err << session_.told() << session_.text("verified.txt");
  EXPECT_EQ(
      session_.text("orders.txt"),
      "both is saved: map version 2\n0\nscan001 is withdrawn: map version 3\n0\n"
      "scan001 stays: The map holds no sweep of that name.\n1\none is saved: map version 3\n0\n"
      "../elsewhere is not saved: a map's name is that of one folder: without a / and not beginning with a dot\n1\n");
  EXPECT_EQ(read_text(session_ / "maps/both/map.ot"), read_text(ShortLog::get().folder / "replay/map.ot"));
  EXPECT_EQ(session_.text("verified.txt"), "");
  EXPECT_NE(session_.text("remarks.txt").find("verified: "), std::string::npos) << session_.text("remarks.txt");
}

TEST_F(Live, TwoMachinesAgree) {
  const auto played = session_.run_on_lan({"-t", "200"}, {R"(
    begin mapper
    touch "$LAN_DIR/mapper-ready"
    while [ ! -e "$LAN_DIR/planner-ready" ]; do sleep 0.1; done
    lcm-logplayer "$LOG"
    wait $pid_mapper)",
                                                          R"(
    while [ ! -e "$LAN_DIR/mapper-ready" ]; do sleep 0.1; done
    begin planner
    observe 2 150
    touch "$LAN_DIR/planner-ready"
    finish)"});
  if (played.status == 125) GTEST_SKIP() << "no pretend LAN here: " << played.err;
  EXPECT_EQ(played.status, 0) << played.err << session_.told();
  expect_same_as_replay();
}

TEST_F(Live, LiesOnEveryChannelAreRefusedAndCountedAndNothingElseChanges) {
  const auto played = session_.run(R"(
    begin mapper
    begin planner
    observe 2 120
    resident() { awk '/VmRSS/ {print $2}' /proc/$1/status; }
    before=$(($(resident $pid_mapper) + $(resident $pid_planner)))
    "$BIN/scanway-live-tool" hostile "$LCM_DEFAULT_URL" || exit 1
    sleep 2
    echo $(($(resident $pid_mapper) + $(resident $pid_planner) - before)) >"$WORK/grown_kb"
    lcm-logplayer "$LOG" || exit 1
    finish)");
  EXPECT_EQ(played.status, 0) << played.err << session_.told();
  for (const char* channel : {"COST_MAP_INDEX index", "OCTOMAP map", "PATH point", "PATH footprint"}) {
    EXPECT_EQ(session_.observed(channel), lines_of(ShortLog::get().products, channel)) << channel << session_.told();
  }
  EXPECT_GT(session_.counters("mapper").at("bad_messages"), 300);
  EXPECT_GT(session_.counters("planner").at("bad_messages"), 300);
  EXPECT_GT(session_.counters("planner").at("planner_bad_messages"), 100);  // Good pieces of bad objects.
  std::printf("both processes grew by %ld kB\n", std::stol(session_.text("grown_kb")));
  EXPECT_LT(std::stol(session_.text("grown_kb")), 8000);  // Thousands of lies of up to 2 GB each.
}

struct Refusal {
  const char* name;
  const char* script;
  const char* says;
};

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, InOneLineThatSaysWhatToDo) {
  if (!namespaces_permitted()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  const Session session;
  const auto refused = session.run(GetParam().script);
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_NE(refused.err.find(GetParam().says), std::string::npos) << refused.err;
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
}

INSTANTIATE_TEST_SUITE_P(
    All, Refused,
    testing::Values(
        Refusal{"no_route", "ip route del 224.0.0.0/4 dev lo; \"$BIN/scanway-mapper\"", "ip route add 224.0.0.0/4"},
        Refusal{"no_loopback", "ip link set lo down; \"$BIN/scanway-planner\"", "ip link set lo up"},
        Refusal{"no_provider", "\"$BIN/scanway-mapper\" --lcm-url xyz://1", "no provider 'xyz'"},
        Refusal{"no_url", "\"$BIN/scanway-mapper\" --lcm-url 239.255.76.67", "not an LCM URL"},
        Refusal{"no_group", "\"$BIN/scanway-planner\" --lcm-url udpm://10.0.0.1:7667", "no multicast address"},
        Refusal{"no_port", "\"$BIN/scanway-planner\" --lcm-url udpm://239.255.76.67:x", "'x' is no port"},
        Refusal{"no_server", "\"$BIN/scanway-mapper\" --lcm-url tcpq://127.0.0.1:7700", "no LCM server answers"},
        Refusal{"no_robot", "\"$BIN/scanway-mapper\" --robot /nowhere.yaml", "/nowhere.yaml"},
        Refusal{"second_mapper", "begin mapper; \"$BIN/scanway-mapper\"", "another mapper (process "},
        Refusal{"second_planner", "begin planner; \"$BIN/scanway-planner\"", "another planner (process "}),
    [](const auto& refusal) { return refusal.param.name; });

TEST_F(Live, AMessageOfAnotherVersionIsNamed) {
  const auto played = session_.run(R"(
    begin planner
    "$BIN/scanway-live-tool" other-version "$LCM_DEFAULT_URL"
    sleep 1
    kill -TERM $pid_planner
    wait $pid_planner)");
  EXPECT_EQ(played.status, 0) << played.err;
  EXPECT_NE(session_.text("planner.err").find("GOAL: not scanway.goal_t but fingerprint 5a5a5a5a5a5a5a5a"),
            std::string::npos)
      << session_.text("planner.err");
}

}  // namespace
}  // namespace scanway::test
