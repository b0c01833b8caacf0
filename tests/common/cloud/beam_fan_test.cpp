#include "common/cloud/beam_fan.h"

#include <cmath>

#include <gtest/gtest.h>

#include "common/random/random.h"

namespace scanway {
namespace {

TEST(BeamFan, HoldsEveryBeamWithoutReturnOnceAndNoOther) {
  Random random(1);
  for (const double step_deg : {0.0417, 0.1667, 1.0, 5.0, 16.7}) {
    const double step = step_deg * M_PI / 180;
    std::vector<bool> none(700);
    for (std::size_t i = 0; i < none.size(); ++i) none[i] = i > 500 || random.below(8) > 0;
    std::vector<int> held(none.size());
    int end_before = 0;
    find_fans(
        static_cast<int>(none.size()), step,
        [&](int i) { return static_cast<bool>(none[static_cast<std::size_t>(i)]); },
        [&](int first, int last) {
          EXPECT_GE(first, end_before);
          EXPECT_LE((last - first) * step, kWidestFan_rad);
          for (int i = first; i <= last; ++i) ++held[static_cast<std::size_t>(i)];
          end_before = last + 1;
        });
    for (std::size_t i = 0; i < none.size(); ++i) ASSERT_EQ(held[i], none[i] ? 1 : 0) << step_deg << " beam " << i;
  }
}

TEST(BeamFan, DirectionsAreThoseOfTheBeamsWhileThePanTurns) {
  // 3 deg/s of pan and 25 turns of the mirror a second: the fan is no plane.
  const double step = M_PI / 1080, pan_step = 3.0 * M_PI / 180 / 54000;
  const auto exact = [&](int beam) {
    const double elevation = -1.0 + beam * step, pan = 2.0 + beam * pan_step;
    return Eigen::Vector3d(std::cos(elevation) * std::cos(pan), std::cos(elevation) * std::sin(pan),
                           std::sin(elevation));
  };
  const int beams = most_beams_of_fan(step);
  EXPECT_GT(beams, 60);
  for (int first = 0; first < 1000; first += beams) {
    const BeamFan fan{to_direction(exact(first)), to_direction(exact(first + beams - 1)),
                      static_cast<std::int16_t>(beams)};
    for (int i = 0; i < beams; ++i) {
      EXPECT_LT((fan.direction(i) - exact(first + i)).norm(), 2e-4);  // A ninth of the way to the next beam.
      EXPECT_NEAR(fan.direction(i).norm(), 1.0, 1e-12);
    }
  }
}

TEST(BeamFan, OfOneBeamHasItsDirection) {
  const BeamFan fan{to_direction({0, 0, -1}), to_direction({0, 0, -1}), 1};
  EXPECT_EQ(fan.direction(0), Eigen::Vector3d(0, 0, -1));
}

}  // namespace
}  // namespace scanway
