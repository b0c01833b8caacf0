// A log that goes on with the map of another session.
#include <gtest/gtest.h>

#include "common/bus/channels.h"
#include "modules/mapper/node/sweep_store.h"
#include "modules/replay/replay.h"
#include "modules/replay/verify/verify.h"
#include "tests/modules/replay/verify/session_log.h"

namespace scanway::test {
namespace {

/// What was measured in the session until a time, or from it on.
std::string measured(const std::string& name, Utime from, Utime until) {
  return SessionLog::get().edited(name, [&](std::vector<EditedEvent>& events) {
    std::erase_if(events, [&](const EditedEvent& event) {
      const bool input = event.channel == channel::kSweep.name || event.channel == channel::kImu.name;
      return !input || event.utime < from || event.utime >= until;
    });
  });
}

class ContinuedMap : public testing::Test {
 protected:
  ContinuedMap() : map_(scratch_ / "map"), path_(scratch_ / "second.lcmlog") {
    const Utime between = (kFirstSweep + kSecondSweep) / 2;
    run(measured("before.lcmlog", 0, between), scratch_ / "first.lcmlog",
        [this](Replay& replay) { replay.keep_in(store_.emplace(map_)); });
    run(measured("after.lcmlog", between, 2 * kSecondSweep), path_,
        [this](Replay& replay) { replay.resume(saved_map(map_)); });
  }

  template <class Prepare>
  static void run(const std::string& log, const std::string& out, const Prepare& prepare) {
    LogWriter recording(out);
    Replay replay(Robot{}, recording);
    prepare(replay);
    LogReader inputs(log);
    replay.run(inputs);
    recording.close();
  }

  ScratchFolder scratch_;
  std::string map_, path_;
  std::optional<SweepStore> store_;
};

TEST_F(ContinuedMap, IsVerifiedWithThatMap) {
  const Verification verification = verify(path_, std::nullopt, {}, {}, map_);
  EXPECT_EQ(verification.status(), Verification::kEqual) << verification.findings();
  EXPECT_EQ(verification.computed, 1U);
  EXPECT_GT(verification.products, 10U) << "the map itself is compared too";
}

TEST_F(ContinuedMap, WithoutItTheLogIsIncompleteAndNotDifferent) {
  const Verification verification = verify(path_, std::nullopt);
  EXPECT_EQ(verification.status(), Verification::kIncomplete) << verification.findings();
}

TEST_F(ContinuedMap, WithAnotherMapItIsDifferent) {
  const std::string other = scratch_ / "other";
  const SweepStore store(other);
  run(measured("other.lcmlog", (kFirstSweep + kSecondSweep) / 2, 2 * kSecondSweep), scratch_ / "other.lcmlog",
      [&store](Replay& replay) { replay.keep_in(store); });
  EXPECT_NE(verify(path_, std::nullopt, {}, {}, other).status(), Verification::kEqual);
}

}  // namespace
}  // namespace scanway::test
