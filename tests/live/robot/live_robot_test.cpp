// A simulated robot with its bridges on one pretend machine, mapper and planner on another one: the map is that of one
// machine, and where the network loses frames every line is there in the end.
#include <gtest/gtest.h>

#include "tests/live/support/session_test.h"

namespace scanway::test {
namespace {

class RobotOnAnotherMachine : public SessionTest {
 protected:
  /// A sweep of the hall, thinned, at four times the speed of the pan and twice that of time.
  CommandResult take_sweep(const std::string& percent) {
    const std::string source = SCANWAY_SOURCE_DIR;
    write_text(session_ / "robot.yaml",
               read_text(source + "/launch/robots/era_mobi_simulated.yaml") + "\npan: {speed_deg_s: 12}\n");
    const std::string head = ". '" + source + "/tests/live/robot/robot.sh'\n. '" + source +
                             "/tests/live/loss/lossy.sh'\n[ " + percent + " = 0 ] || lose " + percent + " || exit 1\n";
    return session_.run_on_lan({"-t", "200"}, {head + R"(
    record "$WORK/robot.lcm"
    while [ ! -e "$WORK/mapper-ready" ]; do sleep 0.1; done
    begin_robot --world hall --seed 3 --speed 2 --host-time --thin 8 && take_sweep
    status=$?
    touch "$WORK/sweep-taken"
    while [ ! -e "$WORK/observed" ]; do sleep 0.2; done
    end_record || status=1
    end_robot || status=1
    exit $status)",
                                               head + R"(
    begin mapper --robot "$ROBOT"
    begin planner --robot "$ROBOT"
    touch "$WORK/mapper-ready"
    while [ ! -e "$WORK/sweep-taken" ]; do sleep 0.2; done
    observe 1 15
    wait $pid_observer  # Nobody asks for a path: it waits for one in vain.
    touch "$WORK/observed"
    status=0
    for pid in $pid_mapper $pid_planner; do kill -TERM $pid; wait $pid || status=1; done
    exit $status)"});
  }
  std::string told() const {
    return session_.text("sweep.txt") + session_.text("simulator.err") + session_.text("sick.err") +
           session_.text("schunk.err") + session_.told();
  }
};

TEST_F(RobotOnAnotherMachine, ItsMapIsThatOfOneMachine) {
  const auto run = take_sweep("0");
  if (run.status == 125) GTEST_SKIP() << "no pretend LAN here: " << run.err;
  ASSERT_EQ(run.status, 0) << run.err << told();
  // In one process, of what the robot's machine has recorded: raw messages, and what came back from the other one.
  const auto verified =
      run_command({std::string(SCANWAY_BIN_DIR) + "/scanway", "replay", "--verify", session_ / "robot.lcm"});
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  std::printf("%s%s", verified.out.c_str(), verified.err.c_str());
  auto mapper = session_.counters("mapper");
  EXPECT_GE(mapper["assembler_sweeps"], 1) << told();
  EXPECT_EQ(mapper["assembler_missing_lines"], 0);
}

TEST_F(RobotOnAnotherMachine, AtOnePercentLossEveryLineIsThereInTheEnd) {
  const auto run = take_sweep("1");
  if (run.status == 125) GTEST_SKIP() << "no pretend LAN here: " << run.err;
  ASSERT_EQ(run.status, 0) << run.err << told();
  auto mapper = session_.counters("mapper"), sick = session_.counters("sick_bridge");
  std::printf("sweeps %ld; lines asked for %ld, sent again %ld; missing lines %ld, beams %ld\n",
              mapper["assembler_sweeps"], mapper["assembler_lines_asked"], sick["sick_lines_resent"],
              mapper["assembler_missing_lines"], mapper["assembler_missing_beams"]);
  EXPECT_GE(mapper["assembler_sweeps"], 1) << told();
  EXPECT_GT(mapper["assembler_lines_asked"], 0);
  EXPECT_GT(sick["sick_lines_resent"], 0);
  EXPECT_EQ(mapper["assembler_missing_lines"], 0);
  EXPECT_EQ(mapper["assembler_missing_beams"], 0);
}

}  // namespace
}  // namespace scanway::test
