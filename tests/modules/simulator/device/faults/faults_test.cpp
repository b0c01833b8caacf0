// What goes wrong with the robot on request: the bridges' devices say it by name, and recover where they can.
#include "modules/simulator/device/faults/fault.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>

#include <gtest/gtest.h>

#include "common/files/input_error.h"
#include "modules/simulator/device/faults/byte_loss.h"
#include "modules/simulator/device/faults/fault_schedule.h"
#include "tests/modules/simulator/device/robot_in_room.h"

namespace scanway::test {
namespace {

using schunk::Axis;

TEST(Fault, IsWrittenAsNameValueAndTimes) {
  const Fault plain = parse_fault("pan-stuck", 7);
  EXPECT_EQ(plain.kind, FaultKind::pan_stuck);
  EXPECT_EQ(plain.value, 1.0);
  EXPECT_EQ(plain.begin, 7);
  EXPECT_EQ(plain.end, Fault::kNever);
  const Fault full = parse_fault("heading-bias=-2.5@1.5+0.25", 1'000'000);
  EXPECT_EQ(full.value, -2.5);
  EXPECT_EQ(full.begin, 2'500'000);
  EXPECT_EQ(full.end, 2'750'000);
  EXPECT_EQ(parse_fault("lms-loss=1e-05@3", 0).value, 1e-5);
  for (const char* wrong :
       {"", "pan", "pan-stuck=", "pan-stuck=x", "pan-stuck@", "pan-stuck@-1", "pan-stuck+3", "slip=2", "slip=-0.1",
        "slip=nan", "people=1@2+", "people=1@2+-1", "people@1@2", "people=1=2"}) {
    EXPECT_THROW(parse_fault(wrong, 0), InputError) << wrong;
  }
  for (std::size_t i = 0; i < fault_forms().size(); ++i) {
    EXPECT_EQ(parse_fault(fault_forms()[i].name, 0).kind, static_cast<FaultKind>(i));
  }
}

TEST(Fault, ComesAndGoesInTheOrderOfItsTimes) {
  FaultSchedule schedule;
  schedule.add({FaultKind::slip, 0.3, 20, 40});
  schedule.add({FaultKind::range_bias, 0.1, 10, 30});
  std::vector<double> values;
  for (const Utime now : {5, 10, 25, 35, 100}) {
    while (const auto change = schedule.next(now)) values.push_back(change->value);
  }
  EXPECT_EQ(values, (std::vector<double>{0.1, 0.3, 0.0, 0.0}));
}

TEST(ByteLoss, LosesItsShareAndTheSameBytesAgain) {
  const std::string all(100'000, 'x');
  ByteLoss one(5), same(5), other(6);
  EXPECT_EQ(one.pass(all), all);
  for (ByteLoss* loss : {&one, &same, &other}) loss->set_share(0.01);
  const std::string left = one.pass(all);
  EXPECT_NEAR(static_cast<double>(left.size()), 99'000.0, 150.0);
  EXPECT_EQ(same.pass(all), left);
  std::string numbers(256, ' ');
  std::iota(numbers.begin(), numbers.end(), '\0');
  EXPECT_NE(same.pass(numbers + numbers), other.pass(numbers + numbers));
}

class FaultyRobot : public RobotInRoom {
 protected:
  bool is_scanning() {
    return run_until([&] { return scans.size() >= 10; });
  }
  bool pan_is_ready() {
    return run_until([&] { return pan_tilt.core().pan().phase() == Axis::Phase::ready; });
  }
  bool is_turning() {
    return run_until([&] { return pan_tilt.core().pan().state() && pan_tilt.core().pan().state()->velocity > 0.1; });
  }
  /// Drives until `done`, which is asked for at each turn.
  template <class Done>
  bool drive_until(double speed_m_s, const Done& done) {
    return run_until([&] {
      base.core().drive(speed_m_s, 0.0, base.now());
      return done();
    });
  }
  /// Ranges of the next scans that see.
  std::vector<double> ranges() {
    scans.clear();
    EXPECT_TRUE(run_until([&] { return scans.size() >= 9; }));
    std::vector<double> all;
    for (const sick::Scan& scan : scans) {
      const sick::ScanChannel& channel = *scan.channel("DIST1");
      for (const auto count : channel.counts) {
        if (count * channel.scale > 1000.0F) all.push_back(count * static_cast<double>(channel.scale) * 1e-3);
      }
    }
    return all;
  }
};

TEST_F(FaultyRobot, LostBytesOfTheLaserAreCountedAndTheScansGoOn) {
  ASSERT_TRUE(is_scanning());
  add_fault("lms-loss=2e-4@0+1.5");
  ASSERT_TRUE(run_until([&] { return lms.counters().bad_bytes > 0 && lms.counters().missed_telegrams > 0; })) << said;
  ASSERT_TRUE(run_until([&, until = now() + 1'600'000] { return now() > until; }));
  ASSERT_TRUE(run_until([&] { return lms.measuring(); }));
  const auto missed = lms.counters().missed_telegrams;
  scans.clear();
  ASSERT_TRUE(is_scanning()) << said;
  EXPECT_LE(lms.counters().missed_telegrams, missed + 1) << "and afterwards none is lost";
}

TEST_F(FaultyRobot, LostBytesOfTrackerAndBaseAreCounted) {
  tracker.emplace(xsens::TrackerAddress{ends.tracker, 0}, xsens::TrackerConfig{});
  ASSERT_TRUE(run_until([&] { return readings.size() > 10 && base.core().ready(); }));
  add_fault("tracker-loss=0.005@0+1");
  add_fault("base-loss=0.005@0+1");
  ASSERT_TRUE(run_until([&] { return tracker->counters().bad_bytes > 0 && base.core().counters().bad_bytes > 0; }));
  ASSERT_TRUE(run_until([&, until = now() + 1'100'000] { return now() > until; }));
  readings.clear();
  EXPECT_TRUE(run_until([&] { return readings.size() > 20 && base.core().ready(); }));
}

TEST_F(FaultyRobot, AStuckPanReportsItsErrorAndTurnsAgainWhenItIsFreeAndAcknowledged) {
  ASSERT_TRUE(pan_is_ready());
  ASSERT_EQ(pan_tilt.core().turn_pan(radians(30), pan_tilt.now()), "");
  ASSERT_TRUE(is_turning());
  add_fault("pan-stuck");
  ASSERT_TRUE(run_until([&] { return has_said("TOW"); })) << said;
  EXPECT_TRUE(has_said("pan")) << said;
  add_fault("pan-stuck=0");
  ASSERT_TRUE(run_until([&, until = now() + 200'000] { return now() > until; }));
  EXPECT_EQ(pan_tilt.core().acknowledge(), "");
  ASSERT_TRUE(run_until([&] { return has_said("has no error any more"); })) << said;
  ASSERT_EQ(pan_tilt.core().turn_pan(radians(30), pan_tilt.now()), "");
  EXPECT_TRUE(is_turning()) << said;
  pan_tilt.core().stop(pan_tilt.now());
}

TEST_F(FaultyRobot, ADirtyWindowIsReportedAndSeesLess) {
  ASSERT_TRUE(is_scanning());
  const std::size_t clean = ranges().size();
  add_fault("dirty-window=0.5");
  ASSERT_TRUE(run_until([&] { return (scans.back().device_status & sick::kPollutionWarning) != 0; }));
  add_fault("dirty-window=0.998");
  ASSERT_TRUE(run_until([&] { return (scans.back().device_status & sick::kPollutionError) != 0; }));
  EXPECT_LT(ranges().size(), clean * 3 / 4);
  ASSERT_TRUE(run_until([&] { return lms.dialogue()->info().contamination.value_or(0) == 2; }))
      << "asked for every 5 s";
  add_fault("dirty-window=0");
  ASSERT_TRUE(run_until([&] { return scans.back().device_status == 0; }));
}

TEST_F(FaultyRobot, ALaserThatRestartsIsConnectedAnew) {
  ASSERT_TRUE(is_scanning());
  add_fault("lms-reboot=1");
  ASSERT_TRUE(run_until([&] { return has_said("closed the connection"); })) << said;
  ASSERT_TRUE(run_until([&] { return lms.connections() == 2 && lms.measuring(); })) << said;
  scans.clear();
  EXPECT_TRUE(is_scanning()) << said;
}

TEST_F(FaultyRobot, APanTiltThatRestartsIsSetUpAnew) {
  ASSERT_TRUE(pan_is_ready());
  add_fault("pan-tilt-reboot=0.5");
  ASSERT_TRUE(run_until([&] { return has_said("(module 11) has restarted"); })) << said;
  ASSERT_TRUE(pan_is_ready());
  EXPECT_EQ(pan_tilt.core().turn_pan(radians(30), pan_tilt.now()), "");
  EXPECT_TRUE(is_turning());
  pan_tilt.core().stop(pan_tilt.now());
}

TEST_F(FaultyRobot, ATrackerThatRestartsIsSetUpAnew) {
  tracker.emplace(xsens::TrackerAddress{ends.tracker, 0}, xsens::TrackerConfig{});
  ASSERT_TRUE(run_until([&] { return readings.size() > 10; }));
  const auto before = tracker->counters().wake_ups;
  add_fault("tracker-reboot=0.5");
  ASSERT_TRUE(run_until([&] { return tracker->counters().wake_ups > before; })) << said;
  readings.clear();
  EXPECT_TRUE(run_until([&] { return readings.size() > 10; })) << said;
}

TEST_F(FaultyRobot, ABaseThatRestartsGoesOnFromWhereItWas) {
  ASSERT_TRUE(run_until([&] { return base.core().ready(); }));
  ASSERT_TRUE(drive_until(0.3, [&] { return base.core().pose().x_m > 0.1; }));
  base.core().stop(base.now());
  ASSERT_TRUE(run_until([&] { return base.core().pose().speed_m_s == 0.0; }));
  EXPECT_FALSE(has_said("restarted")) << said;
  const double x = base.core().pose().x_m;
  add_fault("base-reboot=0.5");
  ASSERT_TRUE(run_until([&] { return has_said("the base has restarted"); })) << said;
  EXPECT_TRUE(run_until([&] { return base.core().ready(); }));
  EXPECT_NEAR(base.core().pose().x_m, x, 0.02);
}

TEST_F(FaultyRobot, ABaseThatHasNotMovedYetAndIsSilentForAWhileHasNotRestarted) {
  ASSERT_TRUE(run_until([&] { return base.core().ready(); }));
  std::this_thread::sleep_for(std::chrono::milliseconds(1000));
  ASSERT_TRUE(run_until([&, until = now() + 300'000] { return now() > until; }));
  EXPECT_FALSE(has_said("restarted")) << said;
}

TEST_F(FaultyRobot, TheTrackersHeadingAndTiltAreOffByTheirBias) {
  tracker.emplace(xsens::TrackerAddress{ends.tracker, 0}, xsens::TrackerConfig{});
  const auto read = [&] {
    readings.clear();
    EXPECT_TRUE(run_until([&] { return readings.size() > 5 && readings.back().q_world_sensor; }));
    return *readings.back().q_world_sensor;
  };
  const Eigen::Quaterniond straight = read();
  add_fault("heading-bias=5");
  run_until([&, until = now() + 100'000] { return now() > until; });
  const Eigen::Quaterniond turned = read();
  const Eigen::AngleAxisd difference(turned * straight.conjugate());
  EXPECT_NEAR(difference.angle(), radians(5), radians(0.2));
  EXPECT_GT(difference.axis().z(), 0.99);
  add_fault("heading-bias=0");
  add_fault("tilt-bias=2");
  run_until([&, until = now() + 100'000] { return now() > until; });
  EXPECT_NEAR(read().angularDistance(straight), radians(2), radians(0.2));
}

TEST_F(FaultyRobot, TheLaserMeasuresTooFarByItsBias) {
  constexpr std::size_t kAhead = 568;  // Of the beams that see, the one next to the horizon.
  const auto ahead_m = [&] {
    scans.clear();
    double sum = 0.0;
    int n = 0;
    EXPECT_TRUE(run_until([&] {
      for (const sick::Scan& scan : std::exchange(scans, {})) {
        const sick::ScanChannel& channel = *scan.channel("DIST1");
        if (channel.counts[kAhead] == 0) continue;
        sum += channel.counts[kAhead] * static_cast<double>(channel.scale) * 1e-3;
        ++n;
      }
      return n >= 8;
    }));
    return sum / n;
  };
  ASSERT_TRUE(is_scanning());
  const double before = ahead_m();
  add_fault("range-bias=0.5");
  ASSERT_TRUE(run_until([&, until = now() + 200'000] { return now() > until; }));
  EXPECT_NEAR(ahead_m() - before, 0.5, 0.03);
}

TEST_F(FaultyRobot, WheelsThatSlipComeLessFarThanTheyCount) {
  add_fault("slip=0.3");
  const Pose X_before = simulated.X_world_base();
  ASSERT_TRUE(run_until([&] { return base.core().ready(); }));
  ASSERT_TRUE(drive_until(0.4, [&] { return base.core().pose().x_m > 0.8; }));
  base.core().stop(base.now());
  ASSERT_TRUE(run_until([&] { return base.core().pose().speed_m_s == 0.0; }));
  run_until([&, until = now() + 200'000] { return now() > until; });
  const double driven = (X_before.inverse() * simulated.X_world_base()).translation().x();
  EXPECT_NEAR(driven / base.core().pose().x_m, 0.7, 0.1);
}

TEST_F(FaultyRobot, AWallStopsItAndItGetsAwayAgain) {
  ASSERT_TRUE(run_until([&] { return base.core().ready(); }));
  ASSERT_TRUE(drive_until(1.0, [&] { return !simulated.obstacle().empty(); })) << said;
  ASSERT_TRUE(drive_until(1.0, [&] { return has_said("a wheel of the base is stalled"); })) << said;
  const Eigen::Vector3d p = simulated.X_world_base().translation(), ahead = simulated.X_world_base().linear().col(0);
  // The footprint's front edge is 0.2 m ahead of the robot's centre; the wall, a cell of 1 cm or two.
  const double reach = 0.2 * std::fabs(ahead.x()) + 0.205 * std::fabs(ahead.y());
  EXPECT_LE(p.x() + reach, room.high.x() + 0.001);
  EXPECT_GT(std::max(p.x() + reach - room.high.x(), p.y() + 0.28 - room.high.y()), -0.15) << p.transpose();
  EXPECT_TRUE(drive_until(-0.5, [&] { return (simulated.X_world_base().translation() - p).norm() > 0.2; }));
  EXPECT_EQ(simulated.obstacle(), "");
  base.core().stop(base.now());
}

TEST_F(FaultyRobot, PeopleAreSeenInFrontOfTheWalls) {
  ASSERT_TRUE(pan_is_ready() && is_scanning());
  ASSERT_EQ(pan_tilt.core().turn_pan(radians(90), pan_tilt.now()), "");
  add_fault("people=5");
  const ScanPattern frames(robot, 0, 0);
  int nearer = 0;
  ASSERT_TRUE(run_until([&] {
    for (const sick::Scan& scan : scans) {
      const sick::ScanChannel& channel = *scan.channel("DIST1");
      for (std::size_t i = 0; i < channel.counts.size(); ++i) {
        const double range = channel.counts[i] * static_cast<double>(channel.scale) * 1e-3;
        const auto time = static_cast<Utime>(scan.start_time_us + static_cast<double>(i) * 40'000.0 / 2160.0);
        const double a = radians(1) * (-5.0 + static_cast<double>(i) / 6.0);
        const Pose X = simulated.X_world_base() * frames.X_base_laser(simulated.pan_angle(time));
        const double wall =
            room.distance(X.translation(), X.linear() * Eigen::Vector3d(std::sin(a), -std::cos(a), 0.0)).first;
        nearer += range > 1.0 && range < wall - 0.5 ? 1 : 0;
      }
    }
    scans.clear();
    return nearer > 20;
  }));
  pan_tilt.core().stop(pan_tilt.now());
}

}  // namespace
}  // namespace scanway::test
