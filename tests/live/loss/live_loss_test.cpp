// Mapper and planner on two pretend machines with a bad network between them: they agree all the same, soon, and the
// counters on both sides and those of the network add up to the last piece (docs/deployment.md).
#include <gtest/gtest.h>

#include <sstream>

#include "tests/live/support/session_test.h"

namespace scanway::test {
namespace {

constexpr double kSoon = 5.0;  // seconds

class TwoMachines : public SessionTest {
 protected:
  using Counters = std::map<std::string, long>;

  /// The number at the end of a file's line that has `word`; 0: there is none.
  double seconds_in(const std::string& file, const std::string& word) const {
    std::istringstream lines(session_.text(file));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("SECONDS") && line.find(word) != std::string::npos) {
        return std::stod(line.substr(line.rfind(':') + 1));
      }
    }
    ADD_FAILURE() << file << " has no line SECONDS with " << word;
    return 0.0;
  }
  void expect_equal_soon() const {
    const double seconds = seconds_in("observed.txt", "first tile");
    std::printf("equal %.2f s after the last version began to come\n", seconds);
    EXPECT_LT(seconds, kSoon);
  }

  /// Of lossy.sh and of the relay: lines "MACHINE-OR-WAY FATE CHANNEL NUMBER".
  Counters fates(const std::string& file, const std::string& where, const std::string& fate) const {
    Counters counters;
    std::istringstream lines(session_.text(file));
    for (std::string place, what, channel; lines >> place >> what >> channel;) {
      long number = 0;
      lines >> number;
      if (place == where && what == fate) counters[channel] = number;
    }
    return counters;
  }
  static long of(const Counters& counters, const std::string& name) {
    const auto found = counters.find(name);
    return found == counters.end() ? 0 : found->second;
  }
  static long of(const Counters& counters, const std::string& prefix, const std::vector<std::string>& channels) {
    long sum = 0;
    for (const std::string& channel : channels) sum += of(counters, prefix + channel);
    return sum;
  }

  /// What left the mapper is what a reader got and what was lost on the way (and came twice).
  static void expect_to_add_up(const Counters& from, const Counters& to, const std::vector<std::string>& channels,
                               long lost, long twice) {
    const long sent = of(from, "sent_", channels), received = of(to, "received_", channels);
    std::printf("%-14s sent %ld + twice %ld = received %ld + lost %ld\n", channels[0].c_str(), sent, twice, received,
                lost);
    EXPECT_EQ(sent + twice, received + lost) << channels[0];
  }
  void expect_identities(const std::string& process) {
    const Counters one = session_.counters(process);
    ASSERT_FALSE(one.empty()) << process;
    EXPECT_EQ(of(one, "kernel_drops"), 0) << process;
    EXPECT_EQ(of(one, "lacking"), 0) << process;
    EXPECT_EQ(of(one, "given_up"), 0) << process;
    EXPECT_EQ(of(one, "bad_messages"), 0) << process;
    EXPECT_EQ(of(one, "pieces_received"), of(one, "pieces_kept") + of(one, "pieces_repeated") +
                                              of(one, "pieces_superseded") + of(one, "pieces_bad"))
        << process;
    EXPECT_EQ(of(one, "pieces_sent") + of(one, "pieces_resent"),
              of(one, "sent_", {"PARAMS", "CLOUD_TILE", "OCTOMAP", "COST_MAP_TILE", "COST_MAP_INDEX", "PATH"}))
        << process;
    std::printf(
        "%s: pieces sent %ld resent %ld; received %ld = kept %ld + repeated %ld + superseded %ld; gaps %ld, "
        "requests %ld, repaired %ld\n",
        process.c_str(), of(one, "pieces_sent"), of(one, "pieces_resent"), of(one, "pieces_received"),
        of(one, "pieces_kept"), of(one, "pieces_repeated"), of(one, "pieces_superseded"), of(one, "gaps"),
        of(one, "requests_sent"), of(one, "repaired"));
  }

  CommandResult run_on_two_machines(const std::string& percent, const std::string& meanwhile = "") {
    const std::string lossy = ". '" SCANWAY_SOURCE_DIR "/tests/live/loss/lossy.sh'\nlose " + percent + " || exit 1\n";
    return session_.run_on_lan({"-t", "300"}, {lossy + R"(
    begin mapper
    touch "$LAN_DIR/mapper-ready"
    while [ ! -e "$LAN_DIR/planner-ready" ]; do sleep 0.1; done
    lcm-logplayer -s 4 "$LOG"
    wait $pid_mapper)",
                                               lossy + R"(
    while [ ! -e "$LAN_DIR/mapper-ready" ]; do sleep 0.1; done
    begin planner
    observe 2 150
    lcm-logplayer -s 4 -e GOAL "$LOG"  # The operator is on this side: the log's player says a goal once.
    touch "$LAN_DIR/planner-ready"
    )" + meanwhile + R"(
    wait $pid_observer; status=$?
    { lost_at a; lost_at b; } >"$WORK/lost.txt"
    kill -TERM $pid_planner
    wait $pid_planner || status=1
    exit $status)"});
  }
};

class Loss : public TwoMachines, public testing::WithParamInterface<int> {};

TEST_P(Loss, IsRepairedAndAddsUp) {
  const auto played = run_on_two_machines(std::to_string(GetParam()));
  if (played.status == 125) GTEST_SKIP() << "no pretend LAN here: " << played.err;
  EXPECT_EQ(played.status, 0) << played.err << session_.told();
  expect_same_end_as_replay();
  expect_equal_soon();
  for (const char* process : {"mapper", "planner", "observer"}) expect_identities(process);
  const Counters mapper = session_.counters("mapper"), planner = session_.counters("planner");
  const Counters observer = session_.counters("observer");
  const Counters at_a = fates("lost.txt", "a", "LOST"), at_b = fates("lost.txt", "b", "LOST");
  expect_to_add_up(mapper, planner, {"COST_MAP_TILE", "COST_MAP_INDEX"}, of(at_b, "COST_MAP"), 0);
  expect_to_add_up(mapper, observer, {"COST_MAP_TILE", "COST_MAP_INDEX"}, of(at_b, "COST_MAP"), 0);
  expect_to_add_up(mapper, observer, {"CLOUD_TILE"}, of(at_b, "CLOUD_TILE"), 0);
  expect_to_add_up(mapper, observer, {"OCTOMAP"}, of(at_b, "OCTOMAP"), 0);
  // A process hears its own requests as well.
  EXPECT_EQ(of(planner, "sent_PIECE_REQUEST") + of(observer, "sent_PIECE_REQUEST") + of(mapper, "sent_PIECE_REQUEST"),
            of(mapper, "received_PIECE_REQUEST") + of(at_a, "PIECE_REQUEST"));
  EXPECT_EQ(of(at_a, "fragments") + of(at_b, "fragments"), 0);  // Every message is one frame.
  EXPECT_GT(of(at_b, "COST_MAP"), 0);
  EXPECT_GT(of(planner, "repaired"), 0);
}

INSTANTIATE_TEST_SUITE_P(Percent, Loss, testing::Values(1, 5), testing::PrintToStringParamName());

struct Network {
  const char* name;
  const char* lost_twice_held_seed;
};

class BadNetwork : public TwoMachines, public testing::WithParamInterface<Network> {};

// Over a relay of our own, as few kernels can disorder.
TEST_P(BadNetwork, ThatDisordersAndRepeatsIsRepairedAndAddsUp) {
  const auto played = session_.run(std::string("export LCM_DEFAULT_URL='udpm://239.255.76.67:7667?ttl=0'\n") + R"(
    "$BIN/scanway-live-tool" relay 239.255.76.67:7667 239.255.76.68:7668 )" +
                                   GetParam().lost_twice_held_seed + R"( \
      >"$WORK/relay.txt" & pid_relay=$!
    begin mapper
    export LCM_DEFAULT_URL='udpm://239.255.76.68:7668?ttl=0'
    begin planner
    observe 2 150
    lcm-logplayer -s 4 -e GOAL "$LOG"
    LCM_DEFAULT_URL='udpm://239.255.76.67:7667?ttl=0' lcm-logplayer -s 4 "$LOG"
    finish; status=$?
    kill -TERM $pid_relay
    wait $pid_relay || status=1
    exit $status)");
  EXPECT_EQ(played.status, 0) << played.err << session_.told();
  expect_same_end_as_replay();
  expect_equal_soon();
  for (const char* process : {"mapper", "planner", "observer"}) expect_identities(process);
  const Counters mapper = session_.counters("mapper"), planner = session_.counters("planner");
  const Counters observer = session_.counters("observer");
  const Counters lost = fates("relay.txt", "ab", "LOST"), twice = fates("relay.txt", "ab", "TWICE");
  expect_to_add_up(mapper, planner, {"COST_MAP_TILE", "COST_MAP_INDEX"},
                   of(lost, "", {"COST_MAP_TILE", "COST_MAP_INDEX"}),
                   of(twice, "", {"COST_MAP_TILE", "COST_MAP_INDEX"}));
  for (const char* channel : {"CLOUD_TILE", "OCTOMAP"}) {
    expect_to_add_up(mapper, observer, {channel}, of(lost, channel), of(twice, channel));
  }
  const long overtaken = of(fates("relay.txt", "ab", "OVERTAKEN"), "COST_MAP_TILE");
  std::printf("%ld tile pieces were overtaken\n", overtaken);
  EXPECT_GT(overtaken, 1000);
  const Counters lost_back = fates("relay.txt", "ba", "LOST"), twice_back = fates("relay.txt", "ba", "TWICE");
  EXPECT_EQ(of(planner, "sent_PIECE_REQUEST") + of(observer, "sent_PIECE_REQUEST") + of(mapper, "sent_PIECE_REQUEST") +
                of(twice_back, "PIECE_REQUEST"),
            of(mapper, "received_PIECE_REQUEST") + of(lost_back, "PIECE_REQUEST"));
}

INSTANTIATE_TEST_SUITE_P(All, BadNetwork,
                         testing::Values(Network{"disorders", "0 0 40 1"}, Network{"repeats", "0 0.2 5 2"},
                                         Network{"does_all_of_it", "0.05 0.1 40 3"}),
                         [](const auto& network) { return network.param.name; });

TEST_F(TwoMachines, ALinkThatIsCutForTwentySecondsIsMadeUpFor) {
  const auto played = run_on_two_machines("0", R"(
    until grep -q began "$WORK/observed.txt"; do sleep 0.02; done  # In the middle of the last version.
    ip link set eth0 down
    sleep 20
    ip link set eth0 up
    ip route add 224.0.0.0/4 dev eth0
    date +'SECONDS since 1970 when the link came back: %s.%N' >"$WORK/back.txt")");
  if (played.status == 125) GTEST_SKIP() << "no pretend LAN here: " << played.err;
  EXPECT_EQ(played.status, 0) << played.err << session_.told();
  expect_same_end_as_replay();
  const double after = seconds_in("observed.txt", "whole") - seconds_in("back.txt", "back");
  std::printf("equal %.2f s after the link came back\n", after);
  EXPECT_GT(after, 0.0) << "the link was cut too late";
  EXPECT_LT(after, kSoon);
}

}  // namespace
}  // namespace scanway::test
