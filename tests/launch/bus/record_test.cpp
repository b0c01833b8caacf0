// launch/record and launch/replay: what was on the bus is in whole logs, and gives the same again.
#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "tests/launch/bus/machine.h"

namespace scanway::test {
namespace {

using nlohmann::json;

/// The logs of a folder, oldest first.
std::vector<std::string> logs_in(const Machine& machine, const std::string& folder) {
  std::vector<std::string> logs;
  for (const auto& entry : std::filesystem::directory_iterator(machine.path(folder))) {
    logs.push_back(folder + "/" + entry.path().filename().string());
  }
  std::sort(logs.begin(), logs.end());
  return logs;
}

/// As "in the year 2026: 2026-11-22T11-30-00.lcm".
bool is_dated(const std::string& log) {
  const std::string name = std::filesystem::path(log).filename().string();
  std::string shape;
  for (const char c : name) shape += c >= '0' && c <= '9' ? '#' : c;
  return shape == "####-##-##T##-##-##.lcm";
}

constexpr const char* kBeginRecording = R"sh(
  env --default-signal=INT "$LAUNCH/record" $OPTIONS logs 2>record.err & record=$!
  for _ in $(seq 100); do [ -n "$(ls logs 2>/dev/null)" ] && break; sleep 0.1; done
  sleep 0.5
)sh";

class Record : public testing::Test {
 protected:
  void SetUp() override {
    if (!namespaces_permitted()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net --mount)";
  }
  CommandResult record(const std::string& options, const std::string& script) const {
    return machine_.run("OPTIONS='" + options + "'\n" + kBeginRecording + script);
  }
  std::string told() const { return machine_.text("record.err"); }

  const Machine machine_;
};

TEST_F(Record, WhatWasRecordedAndReplayedGivesTheSame) {
  write_sweep_log(machine_.path(""), machine_.path("first.lcm"));
  const auto played = record("", R"(
    "$LAUNCH/replay" first.lcm >/dev/null || exit 1
    sleep 0.5
    kill -TERM $record; wait $record || exit 2
    "$SCANWAY" replay first.lcm -o first >/dev/null 2>&1 || exit 3
    "$SCANWAY" replay logs/*.lcm -o again >/dev/null 2>&1 || exit 4)");
  ASSERT_EQ(played.status, 0) << played.err << told();
  const auto logs = logs_in(machine_, "logs");
  ASSERT_EQ(logs.size(), 1U);
  EXPECT_TRUE(is_dated(logs[0])) << logs[0];
  const json first = json::parse(machine_.text("first/report.json"));
  const json again = json::parse(machine_.text("again/report.json"));
  EXPECT_EQ(first["digests"], again["digests"]);
  EXPECT_EQ(first["digests"].size(), 4U);
  const json sent = machine_.info("first.lcm"), recorded = machine_.info(logs[0]);
  for (const json& channel : sent["channels"]) {
    EXPECT_EQ(channel_of(recorded, channel["channel"])["count"], channel["count"]) << channel["channel"];
  }
}

TEST_F(Record, BeginsANewLogWhenOneIsLargeAndLosesNothingBetween) {
  const StreamLog stream(machine_.path("stream.lcm"), 5);
  const auto played = record("--split-mb 0.01", R"(
    "$LAUNCH/replay" --speed 1.25 --channels IMU stream.lcm >/dev/null || exit 1
    sleep 0.5
    kill -INT $record; wait $record)");
  ASSERT_EQ(played.status, 0) << played.err << told();
  const auto logs = logs_in(machine_, "logs");
  EXPECT_GE(logs.size(), 2U) << told();
  std::uint64_t imus = 0;
  for (const std::string& log : logs) {
    EXPECT_TRUE(is_dated(log)) << log;
    const json channel = channel_of(machine_.info(log), "IMU");
    if (!channel.is_null()) imus += channel["count"].get<std::uint64_t>();
  }
  EXPECT_EQ(imus, stream.imus);
}

TEST_F(Record, EndsBeforeTheDiskIsFull) {
  write_sweep_log(machine_.path(""), machine_.path("sweep.lcm"));
  const auto played = machine_.run(R"(
    mkdir logs && mount -t tmpfs -o size=8m tmpfs logs || exit 99
    "$LAUNCH/record" --keep-free-mb 6.5 logs 2>record.err & record=$!
    sleep 1
    while kill -0 $record 2>/dev/null; do lcm-logplayer -s 8 sweep.lcm >/dev/null; done &
    wait $record; echo $? >status
    df --output=avail -B1 logs | tail -n 1 >free
    mkdir kept && cp logs/*.lcm kept/
    "$LAUNCH/record" --keep-free-mb 6.5 logs 2>refused.err; echo $? >>status)");
  if (played.status == 99) GTEST_SKIP() << "no mounts here";
  ASSERT_EQ(played.status, 0) << played.err << told();
  EXPECT_EQ(machine_.text("status"), "3\n2\n") << told();
  EXPECT_NE(told().find("launch/record: stops: only "), std::string::npos) << told();
  EXPECT_GT(std::stol(machine_.text("free")), 1'000'000);
  for (const std::string& log : logs_in(machine_, "kept")) EXPECT_GT(machine_.info(log)["events"], 0);
  EXPECT_NE(machine_.text("refused.err").find("make room"), std::string::npos) << machine_.text("refused.err");
}

TEST_F(Record, NeverOverwrites) {
  const auto played = machine_.run(R"(
    mkdir logs
    for ((s = $(date +%s); s < $(date +%s) + 20; ++s)); do echo precious >"logs/$(date -ud @$s +%Y-%m-%dT%H-%M-%S).lcm"; done
    timeout 10 "$LAUNCH/record" logs 2>record.err; echo $? >status
    cat logs/* | sort -u >kept)");
  EXPECT_EQ(machine_.text("status"), "1\n") << told() << played.err;
  EXPECT_NE(told().find("Refusing to overwrite"), std::string::npos) << told();
  EXPECT_EQ(machine_.text("kept"), "precious\n");
}

TEST_F(Record, SaysInOneLineWhatCannotBe) {
  for (const auto& [options, says] :
       std::vector<std::pair<std::string, std::string>>{{"--lcm-url xyz://1 logs", "no provider 'xyz'"},
                                                        {"--split-mb 0 logs", "--split-mb takes a number above zero"},
                                                        {"--split-hours", "--split-hours takes a number above zero"},
                                                        {"--fast logs", "unknown option '--fast'"},
                                                        {"/proc/logs", "cannot write to the folder '/proc/logs'"},
                                                        {"a b", "one folder, not two"}}) {
    const auto refused = machine_.run("\"$LAUNCH/record\" " + options);
    EXPECT_EQ(refused.status, 2) << options << refused.err;
    EXPECT_NE(refused.err.find(says), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
}

}  // namespace
}  // namespace scanway::test
