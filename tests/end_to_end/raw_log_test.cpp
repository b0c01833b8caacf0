// A log of raw lines, angles and marks through the whole chain: its sweeps are assembled, each once, and register near
// the truth; what was recorded of that is verified from the raw messages.

#include <nlohmann/json.hpp>

#include "common/bus/log_reader.h"
#include "common/bus/log_writer.h"
#include "tests/end_to_end/scanway.h"

namespace scanway::test {
namespace {

using Json = nlohmann::json;

class RawLog : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    const CommandResult made = run_scanway({"simulate", "sweep", "--world", "hall", "--seed", "3", "--pose=-6,0.3,0.5",
                                            "--pose=-4.5,1.0,0.9", "--thin", "6", "-o", path("raw.lcm")});
    ASSERT_EQ(made.status, 0) << made.err;
    const CommandResult replayed = run_scanway({"replay", path("raw.lcm"), "-o", path("first")});
    ASSERT_EQ(replayed.status, 0) << replayed.err;
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string path(const std::string& name) { return *folder_ / name; }
  static Json report(const std::string& name) { return Json::parse(read_text(path(name) + "/report.json")); }
  /// The recorded replay without the n-th message of a channel.
  static std::string without(const std::string& channel, int n, const std::string& name) {
    LogReader log(path("first/out.lcmlog"));
    LogWriter copy(path(name));
    for (int i = 0; const auto event = log.next();) {
      if (event->channel != channel || ++i != n) copy.write(event->channel, event->bytes, event->utime);
    }
    copy.close();
    return path(name);
  }

  static ScratchFolder* folder_;
};
ScratchFolder* RawLog::folder_ = nullptr;

TEST_F(RawLog, TwoSweepsRegisterNearTheTruth) {
  const Json result = report("first");
  ASSERT_EQ(result["scans"].size(), 2u);
  EXPECT_EQ(result["scans"][1]["name"], "sweep_2");
  EXPECT_EQ(result["scans"][1]["verdict"], "accepted");
  EXPECT_LT(result["scans"][1]["error_m"].get<double>(), 0.02);
  EXPECT_LT(result["scans"][1]["error_deg"].get<double>(), 0.1);
  EXPECT_EQ(result["counters"]["assembler_sweeps"], 2);
  EXPECT_EQ(result["counters"]["assembler_missing_lines"], 0);
  EXPECT_EQ(result["counters"]["mapper_sweeps_without_orientation"], 0);
}

TEST_F(RawLog, ASweepThatIsThereInLinesAndAsRecordedIsTakenOnce) {
  const CommandResult again = run_scanway({"replay", path("first/out.lcmlog"), "-o", path("again")});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(report("again")["scans"].size(), 2u);
  EXPECT_EQ(report("again")["digests"], report("first")["digests"]);
}

TEST_F(RawLog, WhatWasDerivedIsVerifiedFromTheRawMessages) {
  const CommandResult verified = run_scanway({"replay", "--verify", path("first/out.lcmlog")});
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  for (const std::string channel : {"LASER_LINE", "IMU"}) {
    const CommandResult lacking = run_scanway({"replay", "--verify", without(channel, 300, channel)});
    EXPECT_EQ(lacking.status, 4) << channel << lacking.out;
    EXPECT_NE(lacking.out.find("missing: " + channel + " from "), std::string::npos) << lacking.out;
  }
}

TEST_F(RawLog, ARecordedSweepThatLacksPiecesIsComparedByItsDigestWithWhatItsLinesGive) {
  const CommandResult verified = run_scanway({"replay", "--verify", without("SWEEP", 300, "pieces")});
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  EXPECT_NE(verified.err.find("compared by its digest alone: SWEEP sweep_"), std::string::npos) << verified.err;
}

TEST_F(RawLog, ARecordedSweepThatIsAlteredIsNamed) {
  LogReader log(path("first/out.lcmlog"));
  LogWriter copy(path("altered"));
  for (int i = 0; const auto event = log.next();) {
    std::vector<std::uint8_t> bytes(event->bytes.begin(), event->bytes.end());
    if (event->channel == "SWEEP" && ++i == 300) bytes.back() ^= 1U;
    copy.write(event->channel, bytes, event->utime);
  }
  copy.close();
  const CommandResult verified = run_scanway({"replay", "--verify", path("altered")});
  EXPECT_NE(verified.status, 0);
  EXPECT_NE((verified.out + verified.err).find("SWEEP sweep_"), std::string::npos) << verified.out << verified.err;
}

}  // namespace
}  // namespace scanway::test
