// scanway spy on a bus: what it shows is what was sent.
#include <gtest/gtest.h>

#include <sstream>

#include "tests/launch/bus/machine.h"

namespace scanway::test {
namespace {

using nlohmann::json;

class Spy : public testing::Test {
 protected:
  void SetUp() override {
    if (!namespaces_permitted()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net --mount)";
  }
  const Machine machine_;
};

TEST_F(Spy, CountsAndDecodesWhatWasSent) {
  const StreamLog stream(machine_.path("stream.lcm"), 2);
  const auto played = machine_.run(R"sh(
    "$SCANWAY" spy --json --seconds 4 >table.json & table=$!
    "$SCANWAY" spy IMU --json --seconds 4 >imu.json & imu=$!
    ("$SCANWAY" spy GOAL --seconds 4 >goal.txt 2>goal.err; echo $? >goal.status) & goal=$!
    "$SCANWAY" spy HEALTH --once >health.txt & health=$!
    sleep 1
    lcm-logplayer stream.lcm >/dev/null
    wait $table && wait $imu && wait $health && wait $goal)sh");
  ASSERT_EQ(played.status, 0) << played.err;

  const json table = json::parse(machine_.text("table.json"));
  const json imu = channel_of(table, "IMU");
  EXPECT_EQ(imu["type"], "bot_core.ins_t");
  EXPECT_EQ(imu["messages"], stream.imus);
  EXPECT_EQ(imu["gaps"], stream.left_out);
  EXPECT_EQ(imu["bad"], 0);
  EXPECT_EQ(channel_of(table, "GOAL")["bad"], 1);
  EXPECT_EQ(channel_of(table, "GOAL")["fault"], "scanway.goal_t.goal_y_m: cut off");

  std::istringstream lines(machine_.text("imu.json"));
  std::uint64_t count = 0;
  std::int64_t last = -1;
  for (std::string line; std::getline(lines, line); ++count) {
    const json message = json::parse(line)["message"];
    EXPECT_GT(message["device_time"], last);
    last = message["device_time"];
    EXPECT_EQ(message["utime"], 1'700'000'000'000'000 + last * 20'000);
    EXPECT_EQ(message["accel"], (json{0.0, 0.0, 9.81}));
  }
  EXPECT_EQ(count, stream.imus);

  EXPECT_EQ(machine_.text("goal.txt"), "GOAL  bad: scanway.goal_t.goal_y_m: cut off\n");
  EXPECT_EQ(machine_.text("goal.status"), "1\n");
  EXPECT_NE(machine_.text("health.txt").find("  process_name  \"tracker\"\n"), std::string::npos)
      << machine_.text("health.txt");
}

TEST_F(Spy, SaysInOneLineWhatCannotBe) {
  for (const auto& [script, says] : std::vector<std::pair<std::string, std::string>>{
           {"\"$SCANWAY\" spy --lcm-url udpm://1.2.3.4:1", "no multicast address"},
           {"\"$SCANWAY\" spy --lcm-url 239.255.76.67", "not an LCM URL"},
           {"\"$SCANWAY\" spy --relay 'udpm://239.255.76.67:7667?ttl=0'", "name another"},
           {"DISPLAY= \"$LAUNCH/spy\"", "there is no display"},
           {"ip route del 224.0.0.0/4 dev lo; \"$SCANWAY\" spy", "ip route add 224.0.0.0/4"}}) {
    const auto refused = machine_.run(script);
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_NE(refused.err.find(says), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
}

}  // namespace
}  // namespace scanway::test
