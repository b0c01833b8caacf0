// The same with processes killed, and many times over.
#include <gtest/gtest.h>

#include "tests/live/support/session_test.h"

namespace scanway::test {
namespace {

class LiveSlow : public SessionTest {};

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

class Speed : public LiveSlow, public testing::WithParamInterface<int> {};

TEST_P(Speed, FiveTimesInARowGiveWhatReplayGives) {
  for (int run = 0; run < 5; ++run) {
    const Session session;
    const auto played = session.run("speed=" + std::to_string(GetParam()) + R"(
      begin mapper
      begin planner
      observe 2 200
      record "$WORK/recorded.lcmlog"
      lcm-logplayer -s $speed "$LOG" || exit 1
      status=0
      finish || status=1
      end_record
      "$BIN/scanway" replay --verify "$WORK/recorded.lcmlog" --played "$LOG" >"$WORK/verified.txt" || status=1
      exit $status)");
    const bool equal = session.observed() == lines_of(ShortLog::get().products, "");
    const std::string said = session.text("verified.txt");
    // A datagram that a busy kernel drops is named, and the status is not 0: a silent difference is worse than that.
    EXPECT_TRUE(equal || (played.status != 0 && said.find("not used: ") != std::string::npos)) << said;
    EXPECT_TRUE(equal) << said << session.told();
    EXPECT_EQ(played.status, 0) << played.err << said << session.told();
  }
}

INSTANTIATE_TEST_SUITE_P(OfTheLog, Speed, testing::Values(1, 4), testing::PrintToStringParamName());

}  // namespace
}  // namespace scanway::test
