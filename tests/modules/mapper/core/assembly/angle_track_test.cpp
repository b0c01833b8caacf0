// The angles of a pan whose states come late: an even turn is found under the delays, and nothing else is made even.
#include "modules/mapper/core/assembly/angle_track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/math/angle.h"
#include "common/random/random.h"

namespace scanway {
namespace {

constexpr Utime kBegan = 1'700'000'000'000'000;

/// How a pan moves, and when it tells where it is.
struct Motion {
  std::function<double(double)> angle_deg;  ///< Over seconds.
  double lasts_s = 20.0;
  double period_s = 0.02;
};

/// From a stand to a stand: one second of rest, `way` degrees at `speed`, with that acceleration at both ends.
double survey_deg(double time_s, double speed, double acceleration, double way) {
  const double t = time_s - 1.0, ramp = speed / acceleration, even = way / speed - ramp;
  if (t < 0.0) return 0.0;
  if (t < ramp) return acceleration * t * t / 2;
  if (t < ramp + even) return speed * (t - ramp / 2);
  const double left = std::max(0.0, 2 * ramp + even - t);
  return way - acceleration * left * left / 2;
}

/// States that come in order, each late by an exponential time.
std::vector<PanTiltAngles> told(const Motion& motion, double mean_delay_s, std::uint64_t seed) {
  Random random(seed);
  std::vector<PanTiltAngles> states;
  double arrived_s = 0.0;
  for (double time_s = 0.0; time_s < motion.lasts_s; time_s += motion.period_s) {
    const double delay_s = mean_delay_s > 0.0 ? -mean_delay_s * std::log(1.0 - random.uniform()) : 0.0;
    arrived_s = std::max(arrived_s + 50e-6, time_s + delay_s);
    const auto pan = static_cast<float>(radians(1) * motion.angle_deg(time_s));
    states.push_back({kBegan + std::llround(arrived_s * 1e6), pan, 0.0});
  }
  return states;
}

struct Off {
  double rms_deg = 0.0, worst_deg = 0.0;
};

Off off(const std::function<double(double)>& found_deg, const Motion& motion) {
  Off off;
  int count = 0;
  for (double time_s = 0.1; time_s < motion.lasts_s - 0.1; time_s += 0.0037, ++count) {
    const double error = std::fabs(found_deg(time_s) - motion.angle_deg(time_s));
    off.rms_deg += error * error;
    off.worst_deg = std::max(off.worst_deg, error);
  }
  off.rms_deg = std::sqrt(off.rms_deg / count);
  return off;
}

Off off_of_track(const std::vector<PanTiltAngles>& states, const Motion& motion) {
  const AngleTrack track(states, 500'000);
  return off(
      [&](double time_s) {
        const auto angles = track.at(time_s * 1e6 - static_cast<double>(track.start() - kBegan));
        return angles ? angles->pan / radians(1) : NAN;
      },
      motion);
}

/// With the states as they came.
Off off_as_told(const std::vector<PanTiltAngles>& states, const Motion& motion) {
  return off(
      [&](double time_s) {
        const double utime = static_cast<double>(kBegan) + time_s * 1e6;
        auto next = std::find_if(states.begin() + 1, states.end() - 1,
                                 [&](const auto& state) { return static_cast<double>(state.utime) > utime; });
        const auto &b = *next, &a = *(next - 1);
        const double share = (utime - static_cast<double>(a.utime)) / static_cast<double>(b.utime - a.utime);
        return (a.pan + share * (b.pan - a.pan)) / radians(1);
      },
      motion);
}

TEST(AngleTrack, AnEvenTurnIsFoundUnderTheDelays) {
  for (const auto& [speed, period_s, delay_s] : {std::array{3.0, 0.02, 0.005},
                                                 {3.0, 0.02, 0.02},
                                                 {-3.0, 0.02, 0.005},
                                                 {60.0, 0.001, 0.001},
                                                 {60.0, 0.01, 0.005}}) {
    const double way = std::fabs(speed) > 10 ? 360.0 : 60.0, times = speed / 3;
    const auto angle = [speed = speed, way, times](double t) {
      return std::copysign(survey_deg(t, std::fabs(speed), 720 * times * times, way), speed);
    };
    const Motion motion{angle, 2.0 + way / std::fabs(speed) + 0.2, period_s};
    const auto states = told(motion, delay_s, 5);
    const Off before = off_as_told(states, motion), after = off_of_track(states, motion);
    EXPECT_LT(after.rms_deg, before.rms_deg / 4) << speed << " deg/s, late by " << delay_s;
    std::printf("%3.0f deg/s, states every %2.0f ms, late by %2.0f ms: off by %.4f deg, as told %.4f\n", speed,
                1e3 * period_s, 1e3 * delay_s, after.rms_deg, before.rms_deg);
  }
}

struct Uneven {
  const char* name;
  Motion motion;
};

class AngleTrackUneven : public testing::TestWithParam<Uneven> {};

TEST_P(AngleTrackUneven, StaysAsItWas) {
  const Motion& motion = GetParam().motion;
  const Off found = off_of_track(told(motion, 0.0, 1), motion);
  EXPECT_LT(found.rms_deg, 0.005);
  EXPECT_LT(found.worst_deg, 0.1) << "a third of its way in a tenth of a second, where its speed changes at once";
}

TEST_P(AngleTrackUneven, DelaysMakeItNoWorseThanItWasTold) {
  const Motion& motion = GetParam().motion;
  const auto states = told(motion, 0.005, 2);
  EXPECT_LT(off_of_track(states, motion).rms_deg, 1.1 * off_as_told(states, motion).rms_deg);
}

double or_later(double time_s, double at_s, double stands_s) {
  return time_s < at_s ? time_s : std::max(at_s, time_s - stands_s);
}

std::vector<Uneven> uneven_turns() {
  return {{"slow_to_speed_up_and_brake", {[](double t) { return survey_deg(t, 3, 3, 48); }}},
          {"stops_dead", {[](double t) { return std::min(3 * t, 30.0); }}},
          {"stuck_for_half_a_second", {[](double t) { return 3 * or_later(t, 10, 0.5); }}},
          {"stuck_for_a_tenth", {[](double t) { return 3 * or_later(t, 10, 0.1); }}},
          {"slows_down", {[](double t) { return t < 10 ? 3 * t : 10 + 2 * t; }}},
          {"gets_faster", {[](double t) { return t < 10 ? 2 * t : 3 * t - 10; }}},
          {"wobbles", {[](double t) { return 3 * t + 0.05 * std::sin(4.4 * t); }}},
          {"turns_back", {[](double t) { return 10 * std::sin(t); }}}};
}

INSTANTIATE_TEST_SUITE_P(Turns, AngleTrackUneven, testing::ValuesIn(uneven_turns()),
                         [](const auto& uneven) { return std::string(uneven.param.name); });

TEST(AngleTrack, StatesOfAStandAreLeftAlone) {
  const Motion motion{[](double) { return 42.0; }};
  EXPECT_LT(off_of_track(told(motion, 0.005, 1), motion).worst_deg, 1e-5);
  EXPECT_FALSE(AngleTrack({}, 500'000).at(0.0).has_value());
  EXPECT_FALSE(AngleTrack({{kBegan, 1.0, 0.0}}, 500'000).at(0.0).has_value());
}

}  // namespace
}  // namespace scanway
