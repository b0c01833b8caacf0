// The same with processes killed, and many times over.
#include <gtest/gtest.h>

#include "tests/live/support/session.h"

namespace scanway::test {
namespace {

class LiveSlow : public testing::Test {
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
  const Session session_;
};

TEST_F(LiveSlow, AMapperThatIsKilledGoesOnWhereItWas) {
  const auto played = session_.run(R"(
    begin mapper
    begin planner
    observe 2 200
    lcm-logplayer -s 4 "$LOG" || exit 1
    sleep 0.3
    kill -KILL $pid_mapper
    wait $pid_mapper
    begin mapper
    finish)");
  EXPECT_EQ(played.status, 0) << played.err << session_.told();
  expect_same_end_as_replay();
}

TEST_F(LiveSlow, APlannerThatIsKilledGetsEverythingAnew) {
  const auto played = session_.run(R"(
    begin mapper
    begin planner
    observe 2 200
    lcm-logplayer -s 4 "$LOG" || exit 1
    kill -KILL $pid_planner
    wait $pid_planner
    begin planner
    finish)");
  EXPECT_EQ(played.status, 0) << played.err << session_.told();
  expect_same_end_as_replay();
}

TEST_F(LiveSlow, FiveTimesInARowAtFullSpeedOfTheLogAndAtFourTimes) {
  for (int run = 0; run < 5; ++run) {
    const Session session;
    const auto played = session.run(std::string("speed=") + (run == 0 ? "1" : "4") + R"(
      begin mapper
      begin planner
      observe 2 200
      lcm-logplayer -s $speed "$LOG" || exit 1
      finish)");
    EXPECT_EQ(played.status, 0) << played.err << session.told();
    EXPECT_EQ(session.observed(), lines_of(ShortLog::get().products, "")) << session.told();
  }
}

}  // namespace
}  // namespace scanway::test
