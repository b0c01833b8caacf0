// What replay --verify says of a log: nothing of a good one, whatever was sent twice; the first product that differs;
// each input that is missing, and nothing else.
#include "modules/replay/verify/verify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/bus/channels.h"
#include "common/bus/log_format.h"
#include "common/config/robot_file.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "common/messages/objects.h"
#include "common/messages/params_message.h"
#include "scanway/cost_tile_t.hpp"
#include "scanway/registration_t.hpp"
#include "scanway/sweep_inputs_t.hpp"
#include "tests/modules/replay/verify/session_log.h"

namespace scanway::test {
namespace {

using Events = std::vector<EditedEvent>;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const SessionLog& session() { return SessionLog::get(); }

piece_t piece_of(const EditedEvent& event) { return decode<piece_t>(event.bytes); }

/// Removes the events of a channel that `goes` says.
template <class Goes>
void drop(Events& events, std::string_view channel, const Goes& goes) {
  std::erase_if(events, [&](const EditedEvent& event) { return event.channel == channel && goes(event); });
}

/// The digest of the first event of a channel, as text.
std::string digest_of(const EditedEvent& event) { return hex(digest(event.bytes)); }

TEST(Verify, IsSilentOnAGoodLog) {
  const Verification verification = verify(session().path(), std::nullopt);
  EXPECT_EQ(verification.status(), Verification::kEqual) << verification.findings();
  EXPECT_EQ(verification.computed, 2U);
  EXPECT_THAT(verification.notes, IsEmpty());
  EXPECT_GT(verification.products, 20U);
  EXPECT_EQ(verification.findings(), "");
  EXPECT_THAT(verification.remarks(), StartsWith("verified: "));
}

TEST(Verify, OfALogWithoutProductsThereIsNothingToSay) {
  EXPECT_EQ(verify(session().inputs_path(), std::nullopt).status(), Verification::kNothingDerived);
}

TEST(Verify, WhatWasSentTwiceOrInAnotherOrderCountsOnce) {
  const std::string path = session().edited("twice.lcmlog", [](Events& events) {
    const Events once = events;
    events.insert(events.end(), once.begin(), once.end());
    std::mt19937 random(1);
    std::shuffle(events.begin(), events.end(), random);
    // The mapper says what it used of a sweep before it goes on to the next.
    std::ranges::stable_sort(events, {}, [](const EditedEvent& event) { return event.channel == "SWEEP_INPUTS"; });
    auto listed = events_of(events, "SWEEP_INPUTS");
    std::vector<std::vector<std::uint8_t>> in_order;
    for (const EditedEvent* event : listed) in_order.push_back(event->bytes);
    std::ranges::stable_sort(in_order, {}, [](const auto& bytes) { return decode<sweep_inputs_t>(bytes).utime; });
    for (std::size_t i = 0; i < listed.size(); ++i) listed[i]->bytes = in_order[i];
  });
  const Verification verification = verify(path, std::nullopt);
  EXPECT_EQ(verification.status(), Verification::kEqual) << verification.findings();
  EXPECT_EQ(verification.products, verify(session().path(), std::nullopt).products);
}

TEST(Verify, WhatCarriesAndSurroundsTheProductsIsNotCompared) {
  const std::string path = session().edited("surrounded.lcmlog", [](Events& events) {
    for (const char* channel : {"HEALTH", "TIMING", "OBJECT_INDEX", "PIECE_REQUEST", "MAP_STATE", "SOMEBODY_ELSES"}) {
      events.push_back({channel, kSecondSweep, {1, 2, 3}});
    }
  });
  EXPECT_EQ(verify(path, std::nullopt).status(), Verification::kEqual);
}

class AlteredByte : public testing::TestWithParam<const char*> {};

TEST_P(AlteredByte, IsNamed) {
  const std::string channel = GetParam();
  std::mt19937 random(7);
  const std::string path = session().edited("altered-" + channel + ".lcmlog", [&](Events& events) {
    const auto of_channel = events_of(events, channel);
    ASSERT_FALSE(of_channel.empty());
    auto& bytes = of_channel[random() % of_channel.size()]->bytes;
    // The last bytes of SWEEP_INPUTS count what came too late, which is not compared.
    const std::size_t end = channel == "SWEEP_INPUTS" ? bytes.size() - 8 : bytes.size();
    bytes[8 + random() % (end - 8)] ^= 0x10;
  });
  const Verification verification = verify(path, std::nullopt);
  EXPECT_NE(verification.status(), Verification::kEqual);
  // An altered list asks for inputs that there never were.
  EXPECT_THAT(verification.findings(), HasSubstr(channel == "SWEEP_INPUTS" ? "missing: IMU" : channel));
}

INSTANTIATE_TEST_SUITE_P(OfAnObject, AlteredByte,
                         testing::Values("SWEEP_INPUTS", "REGISTRATION", "POSE", "COST_MAP_TILE", "COST_MAP_INDEX",
                                         "CLOUD_TILE", "OCTOMAP", "PATH", "SWEEP", "IMU"),
                         [](const auto& channel) { return std::string(channel.param); });

TEST(Verify, AByteInAPiecesHeaderIsNamedToo) {
  for (const std::size_t at : {3U, 15U, 30U, 40U, 60U}) {
    const std::string path = session().edited(
        "header.lcmlog", [&](Events& events) { events_of(events, "OCTOMAP").front()->bytes[at] ^= 0x04; });
    EXPECT_THAT(verify(path, std::nullopt).findings(), HasSubstr("OCTOMAP")) << at;
  }
}

TEST(Verify, AnotherProductUnderTheSameNameIsNamedWithBothDigests) {
  std::int64_t recorded = 0, derived = 0;
  const std::string path = session().edited("other.lcmlog", [&](Events& events) {
    EditedEvent& event = *events_of(events, "REGISTRATION").back();
    auto verdict = decode<registration_t>(event.bytes);
    derived = static_cast<std::int64_t>(digest(event.bytes));
    verdict.overlap += 1e-12;
    event.bytes = encode(verdict);
    recorded = static_cast<std::int64_t>(digest(event.bytes));
  });
  const Verification verification = verify(path, std::nullopt);
  EXPECT_EQ(verification.status(), Verification::kDifferent);
  EXPECT_EQ(verification.difference, "REGISTRATION at " + std::to_string(kSecondSweep) + ": digest " +
                                         hex(static_cast<std::uint64_t>(recorded)) + " in the log, " +
                                         hex(static_cast<std::uint64_t>(derived)) + " derived from it");
}

TEST(Verify, AProductThatNothingGivesIsNamed) {
  const std::string path = session().edited("invented.lcmlog", [](Events& events) {
    cost_tile_t tile{};
    tile.utime = kSecondSweep;
    const std::string key = "99,99";
    for (const piece_t& piece : cut(encode(tile), key, 2, tile.utime)) {
      events.push_back({"COST_MAP_TILE", kSecondSweep, encode(piece)});
    }
  });
  EXPECT_THAT(verify(path, std::nullopt).difference, HasSubstr("COST_MAP_TILE 99,99 version 2"));
}

TEST(Verify, AnObjectThatIsNoMessageOfItsChannelIsNamed) {
  for (const char* channel : {"PATH", "COST_MAP_INDEX", "CLOUD_TILE"}) {
    const std::string path = session().edited("liar.lcmlog", [&](Events& events) {
      for (const piece_t& piece : cut(std::vector<std::uint8_t>(40, 0x5A), "liar", 1, 0x5A5A5A5A5A5A5A5A)) {
        events.push_back({channel, kSecondSweep, encode(piece)});
      }
    });
    const Verification verification = verify(path, std::nullopt);
    EXPECT_EQ(verification.status(), Verification::kDifferent);
    EXPECT_THAT(verification.findings(), HasSubstr(std::string(channel) + " liar version 1"));
  }
}

TEST(Verify, TheOrientationThatASweepUsedIsNamedWhenItIsMissing) {
  std::string name;
  const std::string path = session().edited("no-imu.lcmlog", [&](Events& events) {
    name = digest_of(*events_of(events, "IMU").back());
    drop(events, "IMU", [&](const EditedEvent& event) { return digest_of(event) == name; });
  });
  const Verification verification = verify(path, std::nullopt);
  EXPECT_EQ(verification.status(), Verification::kIncomplete);
  EXPECT_THAT(verification.missing,
              ElementsAre("IMU at " + std::to_string(kSecondSweep - kImuBefore) + " digest " + name));
  EXPECT_EQ(verification.difference, "");
  EXPECT_EQ(verification.computed, 1U);
}

TEST(Verify, ExactlyThePiecesOfASweepThatAreMissingAreNamed) {
  std::string name;
  std::int32_t npieces = 0;
  const std::string path = session().edited("no-pieces.lcmlog", [&](Events& events) {
    const piece_t first = piece_of(*events_of(events, "SWEEP").front());
    name = hex(static_cast<std::uint64_t>(first.digest));
    npieces = first.npieces;
    drop(events, "SWEEP", [&](const EditedEvent& event) {
      const piece_t piece = piece_of(event);
      return piece.digest == first.digest && (piece.piece == 1 || piece.piece == 3 || piece.piece == 4);
    });
  });
  const Verification verification = verify(path, std::nullopt);
  EXPECT_EQ(verification.status(), Verification::kIncomplete);
  EXPECT_THAT(verification.missing, ElementsAre("SWEEP first at " + std::to_string(kFirstSweep) + " digest " + name +
                                                ": 3 of " + std::to_string(npieces) + " pieces (1, 3-4)"));
  EXPECT_EQ(verification.computed, 0U) << "the second rests on the first";
}

TEST(Verify, AMissingGoalIsNamed) {
  const std::string path = session().edited(
      "no-goal.lcmlog", [](Events& events) { drop(events, "GOAL", [](const auto&) { return true; }); });
  const Verification verification = verify(path, std::nullopt);
  EXPECT_EQ(verification.status(), Verification::kIncomplete);
  ASSERT_EQ(verification.missing.size(), 1U);
  EXPECT_THAT(verification.missing[0], StartsWith("GOAL 0.8,0.4 "));
}

TEST(Verify, ASweepThatIsNotListedIsNotCalledDifferent) {
  for (const Utime lost : {kFirstSweep, kSecondSweep}) {
    const std::string path = session().edited("not-listed.lcmlog", [&](Events& events) {
      drop(events, "SWEEP_INPUTS",
           [&](const EditedEvent& event) { return decode<sweep_inputs_t>(event.bytes).utime == lost; });
    });
    const Verification verification = verify(path, std::nullopt);
    EXPECT_EQ(verification.status(), Verification::kIncomplete) << verification.findings();
    ASSERT_EQ(verification.missing.size(), 1U);
    EXPECT_THAT(verification.missing[0], StartsWith("SWEEP_INPUTS at " + std::to_string(lost)));
    EXPECT_EQ(verification.computed, lost == kFirstSweep ? 0U : 1U);
  }
}

TEST(Verify, ALogThatBeginsInTheMiddleIsIncomplete) {
  const std::string path = session().edited("late.lcmlog", [](Events& events) {
    std::erase_if(events, [](const EditedEvent& event) {
      return event.channel != "PARAMS" && event.channel != "GOAL" && event.utime < kSecondSweep - kImuBefore;
    });
    // In a replay's log, what is derived of the first comes when the second's orientation does.
    std::erase_if(events, [](const EditedEvent& event) {
      const Channel* const channel = find_channel(event.channel);
      if (event.channel == "PARAMS" || event.channel == "GOAL" || event.channel == "PATH") return false;
      if (channel->cut) return decode<piece_t>(event.bytes).utime == kFirstSweep;
      return event.channel != "IMU" && event.channel != "SWEEP" &&
             static_cast<Utime>(log_format::get<std::uint64_t>(event.bytes.data() + 8)) == kFirstSweep;
    });
  });
  const Verification verification = verify(path, std::nullopt);
  EXPECT_EQ(verification.status(), Verification::kIncomplete) << verification.findings();
  EXPECT_THAT(verification.missing, testing::Contains(HasSubstr("made map version 2, and the log lists 1")));
}

TEST(Verify, AProductWhosePiecesAreNotAllThereIsComparedByItsDigestAndNamed) {
  const std::string path = session().edited("torn.lcmlog", [](Events& events) {
    drop(events, "OCTOMAP", [](const EditedEvent& event) {
      const piece_t piece = piece_of(event);
      return piece.version == 1 && piece.piece == 0;
    });
  });
  const Verification verification = verify(path, std::nullopt);
  EXPECT_EQ(verification.status(), Verification::kEqual);
  ASSERT_EQ(verification.notes.size(), 1U);
  EXPECT_THAT(verification.notes[0], HasSubstr("OCTOMAP map version 1: lacks 1 of "));
}

TEST(Verify, WhatWasPlayedAndNotUsedIsNamed) {
  const auto played_into = [](const std::string& log) {
    return verify(log, std::nullopt, {}, session().inputs_path());
  };
  EXPECT_EQ(played_into(session().path()).status(), Verification::kEqual);
  // A session whose processes never got the second scan, the first one's orientation and the goal.
  const std::string path = session().edited("got-less.lcmlog", [](Events& events) {
    drop(events, "PATH", [](const auto&) { return true; });
    for (EditedEvent* event : events_of(events, "SWEEP_INPUTS")) {
      auto inputs = decode<sweep_inputs_t>(event->bytes);
      inputs.inputs[0].used_count = 0;
      event->bytes = encode(inputs);
    }
    drop(events, "SWEEP_INPUTS",
         [](const EditedEvent& event) { return decode<sweep_inputs_t>(event.bytes).utime == kSecondSweep; });
  });
  const Verification verification = played_into(path);
  EXPECT_NE(verification.status(), Verification::kEqual);
  EXPECT_THAT(verification.unused,
              testing::UnorderedElementsAre(StartsWith("IMU at " + std::to_string(kFirstSweep - kImuBefore)),
                                            StartsWith("SWEEP second at " + std::to_string(kSecondSweep)),
                                            StartsWith("GOAL 0.8,0.4 ")));
}

/// Adds what a live process says of its configuration.
void say(Events& events, const std::string& process, const Robot& robot) {
  const auto message = encode(params_message(kFirstSweep, robot_text(robot)));
  for (const piece_t& piece : cut(message, process, kFirstSweep, kFirstSweep)) {
    events.push_back({"PARAMS", kFirstSweep, encode(piece)});
  }
}

TEST(Verify, SaysWhenMapperAndPlannerRanWithDifferentConfigurations) {
  Robot other;
  other.body.height_m += 0.25;
  const std::string path = session().edited("two-robots.lcmlog", [&](Events& events) {
    say(events, "mapper", Robot{});
    say(events, "planner", other);
  });
  const Verification verification = verify(path, std::nullopt);
  ASSERT_FALSE(verification.notes.empty());
  EXPECT_THAT(verification.notes[0], HasSubstr("mapper and planner ran with different configurations"));
  EXPECT_THAT(verification.notes[0], HasSubstr("height_m"));
}

TEST(Verify, TheConfigurationInForceIsTheLogsUnlessOneIsGiven) {
  Robot other;
  other.mapping.embodiment = Embodiment::paper;
  const std::string path =
      session().edited("other-robot.lcmlog", [&](Events& events) { say(events, "mapper", other); });
  EXPECT_EQ(verify(path, std::nullopt).status(), Verification::kDifferent);
  EXPECT_EQ(verify(path, Robot{}).status(), Verification::kEqual);
}

TEST(Verify, WithoutAConfigurationNothingIsCalledDifferent) {
  const std::string path = session().edited(
      "no-params.lcmlog", [](Events& events) { drop(events, "PARAMS", [](const auto&) { return true; }); });
  const Verification verification = verify(path, std::nullopt);
  EXPECT_EQ(verification.status(), Verification::kIncomplete);
  EXPECT_THAT(verification.missing, ElementsAre(StartsWith("PARAMS")));
  EXPECT_EQ(verify(path, Robot{}).status(), Verification::kEqual);
}

}  // namespace
}  // namespace scanway::test
