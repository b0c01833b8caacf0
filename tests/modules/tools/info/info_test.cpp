#include "modules/tools/logs/info.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/bus/log_bus.h"
#include "common/files/input_error.h"
#include "common/messages/codec.h"
#include "common/messages/goal_message.h"
#include "common/messages/objects.h"
#include "common/messages/params_message.h"
#include "common/messages/sweep_message.h"
#include "tests/support/command.h"

namespace scanway::tools {
namespace {

using nlohmann::json;

struct Answer {
  int status;
  std::string out;
  std::string err;
  json document() const { return json::parse(out); }
};

Answer info(const std::string& log, bool as_json) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int status = run_info({log, as_json});
  return {status, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

std::vector<std::uint8_t> a_sweep() {
  Sweep sweep;
  sweep.name = "scan";
  for (int i = 0; i < 2000; ++i) sweep.cloud.points.emplace_back(static_cast<float>(i * i % 97), 1.0F / (1 + i), 0.0F);
  return encode(to_message(sweep));
}

/// PARAMS, a SWEEP in pieces, and three GOALs half a second apart.
std::string write_log(const test::ScratchFolder& scratch) {
  const std::string path = scratch / "log.lcmlog";
  LogWriter log(path);
  LogBus bus(log);
  publish_object(bus, channel::kParams, encode(params_message(1000, "name: era_mobi\n")), kParamsKey, 1000, 1000);
  publish_object(bus, channel::kSweep, a_sweep(), "scan", 5000, 5000);
  for (int i = 0; i < 3; ++i) {
    const Utime utime = 1'000'000 + i * 500'000;
    bus.publish("GOAL", encode(goal_message(utime, {1, 2})), utime);
  }
  log.close();
  return path;
}

json channel_of(const json& document, const std::string& name) {
  for (const json& channel : document["channels"]) {
    if (channel["channel"] == name) return channel;
  }
  return {};
}

TEST(Info, SaysWhatALogHolds) {
  const test::ScratchFolder scratch;
  const std::string log = write_log(scratch);
  const Answer answer = info(log, true);
  EXPECT_EQ(answer.status, 0);
  EXPECT_EQ(answer.err, "");
  const json document = answer.document();
  EXPECT_EQ(document["schema"], 1);
  EXPECT_EQ(document["damaged"], false);
  const json goal = channel_of(document, "GOAL");
  EXPECT_EQ(goal["type"], "scanway.goal_t");
  EXPECT_EQ(goal["count"], 3);
  EXPECT_EQ(goal["rate_hz"], 2.0);
  EXPECT_EQ(goal["first_utime"], 1'000'000);
  EXPECT_EQ(goal["last_utime"], 2'000'000);
  const json sweep = channel_of(document, "SWEEP");
  EXPECT_EQ(sweep["type"], "scanway.piece_t");
  EXPECT_EQ(sweep["objects"]["type"], "scanway.sweep_t");
  EXPECT_EQ(sweep["objects"]["complete"], 1);
  EXPECT_EQ(sweep["objects"]["missing_pieces"], 0);
  const Answer table = info(log, false);
  EXPECT_EQ(table.status, 0);
  EXPECT_NE(table.out.find("scanway.sweep_t (pieces)"), std::string::npos);
}

TEST(Info, CountsMissingPieces) {
  const test::ScratchFolder scratch;
  LogWriter log(scratch / "log");
  const auto pieces = cut(a_sweep(), "scan", 1, 0);
  ASSERT_GT(pieces.size(), 4U);
  for (const piece_t& piece : pieces) {
    if (piece.piece % 2 == 0) log.write("SWEEP", encode(piece), 0);
  }
  log.close();
  const Answer answer = info(scratch / "log", true);
  EXPECT_EQ(answer.status, 0);  // What the network lost is no damage of the log.
  const json objects = channel_of(answer.document(), "SWEEP")["objects"];
  EXPECT_EQ(objects["complete"], 0);
  EXPECT_EQ(objects["incomplete"], 1);
  EXPECT_EQ(objects["missing_pieces"], pieces.size() / 2);
}

TEST(Info, NamesOneAlteredByteOfAnObject) {
  const test::ScratchFolder scratch;
  std::string bytes = test::read_text(write_log(scratch));
  bytes[bytes.find("SWEEP") + 600] ^= 1;
  test::write_text(scratch / "altered", bytes);
  const Answer answer = info(scratch / "altered", true);
  EXPECT_EQ(answer.status, 1);
  EXPECT_EQ(channel_of(answer.document(), "SWEEP")["objects"]["bad"], 1);
  EXPECT_NE(answer.err.find("SWEEP: object 'scan'"), std::string::npos) << answer.err;
}

TEST(Info, ReportsACutLogAndBadMessages) {
  const test::ScratchFolder scratch;
  const std::string bytes = test::read_text(write_log(scratch));
  test::write_text(scratch / "cut", bytes.substr(0, bytes.size() - 5));
  const Answer cut = info(scratch / "cut", true);
  EXPECT_EQ(cut.status, 1);
  EXPECT_EQ(cut.document()["cut"], true);
  EXPECT_EQ(channel_of(cut.document(), "GOAL")["count"], 2);
  EXPECT_NE(cut.err.find("cut off at byte"), std::string::npos);

  LogWriter log(scratch / "bad");
  auto goal = encode(goal_message(1, {1, 2}));
  goal.pop_back();
  log.write("GOAL", goal, 1);
  log.write("GOAL", encode(params_message(1, "")), 2);
  log.write("N\xFF\n", {}, 3);
  log.close();
  const Answer bad = info(scratch / "bad", true);
  EXPECT_EQ(bad.status, 1);
  EXPECT_EQ(channel_of(bad.document(), "GOAL")["bad_messages"], 1);
  EXPECT_EQ(channel_of(bad.document(), "GOAL")["unexpected_type"], 1);
  EXPECT_EQ(channel_of(bad.document(), "N\\xFF\\n")["count"], 1);
}

TEST(Info, ReadsForeignLogs) {
  const std::string folder = SCANWAY_SHARED_DIR "/data/lcm_logs/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  const json maebot = info(folder + "maebot_convex.lcmlog", true).document();
  EXPECT_EQ(maebot["events"], 5714);
  EXPECT_EQ(channel_of(maebot, "MAEBOT_ENCODERS")["type"], "7d090bfb221d74f9");
  EXPECT_EQ(channel_of(maebot, "RPLIDAR_LASER")["count"], 459);
  const json example = info(folder + "lcm_example.lcmlog", true).document();
  EXPECT_EQ(channel_of(example, "JOINT_TEST")["type"], "bot_core.joint_state_t");
  EXPECT_EQ(example["damaged"], false);
}

TEST(Info, RefusesWhatIsNoLog) {
  const test::ScratchFolder scratch;
  test::write_text(scratch / "text", "hello");
  EXPECT_THROW(run_info({scratch / "text", true}), InputError);
  EXPECT_THROW(run_info({scratch / "absent", true}), InputError);
}

}  // namespace
}  // namespace scanway::tools
