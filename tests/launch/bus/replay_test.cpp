// launch/replay plays what live processes need, and says what stands against it.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "tests/launch/bus/machine.h"

namespace scanway::test {
namespace {

using nlohmann::json;

class ReplayScript : public testing::Test {
 protected:
  void SetUp() override {
    if (!namespaces_permitted()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net --mount)";
  }
  const Machine machine_;
};

TEST_F(ReplayScript, PlaysWhatSensorsAndOperatorsSentAndNothingDerived) {
  const StreamLog stream(machine_.path("stream.lcm"), 1);
  const auto played = machine_.run(R"(
    "$SCANWAY" spy --json --seconds 2.5 >inputs.json & spy=$!
    sleep 0.5
    "$LAUNCH/replay" --anyway stream.lcm >/dev/null || exit 1
    wait $spy
    "$SCANWAY" spy --json --seconds 2.5 >all.json & spy=$!
    sleep 0.5
    "$LAUNCH/replay" --anyway --all stream.lcm >/dev/null || exit 2
    wait $spy)");
  ASSERT_EQ(played.status, 0) << played.err;
  const json inputs = json::parse(machine_.text("inputs.json")), all = json::parse(machine_.text("all.json"));
  EXPECT_EQ(channel_of(inputs, "IMU")["messages"], stream.imus);
  EXPECT_EQ(channel_of(inputs, "GOAL")["bad"], 1);
  EXPECT_TRUE(channel_of(inputs, "HEALTH").is_null());
  EXPECT_EQ(channel_of(all, "HEALTH")["messages"], 1);
}

TEST_F(ReplayScript, NotIntoALivingRobot) {
  const StreamLog stream(machine_.path("stream.lcm"), 5);
  const auto played = machine_.run(R"(
    lcm-logplayer -e IMU stream.lcm >/dev/null & robot=$!
    sleep 0.3
    "$LAUNCH/replay" stream.lcm)");
  EXPECT_EQ(played.status, 2);
  EXPECT_NE(played.err.find("somebody sends on IMU already"), std::string::npos) << played.err;
  EXPECT_EQ(std::count(played.err.begin(), played.err.end(), '\n'), 1) << played.err;
}

TEST_F(ReplayScript, SaysInOneLineWhatCannotBe) {
  write_text(machine_.path("text"), "no log\n");
  const StreamLog stream(machine_.path("stream.lcm"), 1);
  for (const auto& [options, says] : std::vector<std::pair<std::string, std::string>>{
           {"", "which log?"},
           {"nowhere.lcm", "there is no log 'nowhere.lcm'"},
           {"text", "'text' is no LCM log"},
           {"--speed fast stream.lcm", "--speed takes a number, not 'fast'"},
           {"--lcm-url udpm://10.0.0.1:7667 stream.lcm", "no multicast address"}}) {
    const auto refused = machine_.run("\"$LAUNCH/replay\" " + options);
    EXPECT_EQ(refused.status, 2) << options << refused.err;
    EXPECT_NE(refused.err.find(says), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
}

// lcmtypes/README.md says who sends what.
TEST(ReplayScriptInputs, AreWhatTheTableOfChannelsSays) {
  std::set<std::string> from_table;
  std::istringstream table(read_text(SCANWAY_SOURCE_DIR "/lcmtypes/README.md"));
  for (std::string line; std::getline(table, line);) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(cell);
    if (cells.size() < 6 || !line.starts_with("| ") || line.starts_with("| channel")) continue;
    const std::string& publisher = cells[4];
    const bool is_input = publisher.find("import") != std::string::npos ||
                          publisher.find("bridge") != std::string::npos ||
                          publisher.find("operator") != std::string::npos;
    const std::string channel = cells[1].substr(1, cells[1].size() - 2);
    if (is_input && channel.find("COMMAND") == std::string::npos) from_table.insert(channel);
  }
  const std::string script = read_text(SCANWAY_SOURCE_DIR "/launch/replay");
  const std::size_t begin = script.find("inputs='") + 8;
  std::istringstream list(script.substr(begin, script.find('\'', begin) - begin));
  std::set<std::string> from_script;
  for (std::string channel; std::getline(list, channel, '|');) from_script.insert(channel);
  EXPECT_EQ(from_script, from_table);
}

}  // namespace
}  // namespace scanway::test
