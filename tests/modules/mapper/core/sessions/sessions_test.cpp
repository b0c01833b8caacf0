// A robot that comes back: on another day, or to where it was long ago.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "modules/mapper/core/mapper.h"
#include "modules/simulator/core/simulator.h"

namespace scanway {
namespace {

constexpr double kRight = 0.1;  // metres
constexpr int kThin = 3;

/// A robot that is put down in the street.
class Surveyor {
 public:
  Surveyor() : world_(simulator::make_world("street", 5)), places_(simulator::places_on_route(world_, 16)) {}

  /// `heading`: by how much the tracker's zero is off, as after a new start.
  SweepResult scan(std::size_t place, double heading = 0.0) {
    auto simulated = simulator::simulate_sweep(world_, places_.at(place), Robot{}, {.seed = ++seed_, .thin = kThin});
    Sweep& sweep = simulated.sweep;
    sweep.name = "place" + std::to_string(place);
    sweep.utime += static_cast<Utime>(seed_) * 200 * kMicrosecondsPerSecond;
    sweep.R_world_sweep = Eigen::Quaterniond(rotation_about_z(heading)) * *sweep.R_world_sweep;
    const SweepResult result = mapper_.add(sweep);
    if (result.verdict == Verdict::accepted) {
      if (mapper_.trajectory().size() == 1) X_map_world_ = result.X_map_sweep * simulated.X_world_base.inverse();
      error_m_ = (X_map_world_ * simulated.X_world_base.translation() - result.X_map_sweep.translation()).norm();
    }
    return result;
  }

  SweepResult scan_elsewhere() {
    const simulator::World hall = simulator::make_world("hall", 3);
    const auto place = simulator::places_on_route(hall, 1).front();
    auto simulated = simulator::simulate_sweep(hall, place, Robot{}, {.seed = ++seed_, .thin = kThin});
    simulated.sweep.name = "hall";
    return mapper_.add(simulated.sweep);
  }

  Mapper& mapper() { return mapper_; }
  double error_m() const { return error_m_; }  ///< Of the newest accepted sweep.
  std::string octomap() const { return mapper_.map().occupancy_tree().ot_bytes(); }

 private:
  simulator::World world_;
  std::vector<simulator::Place> places_;
  Mapper mapper_{Robot{}};
  std::uint64_t seed_ = 0;
  Pose X_map_world_ = Pose::Identity();
  double error_m_ = 0.0;
};

void expect_right(const Surveyor& surveyor, const SweepResult& result) {
  EXPECT_EQ(result.verdict, Verdict::accepted) << result.reason;
  EXPECT_LT(surveyor.error_m(), kRight) << result.name;
}

TEST(Sessions, EachIsFoundInTheMapAndGoesOn) {
  Surveyor surveyor;
  for (const std::size_t place : {0u, 1u, 2u, 3u}) expect_right(surveyor, surveyor.scan(place));
  surveyor.mapper().begin_session();
  expect_right(surveyor, surveyor.scan(1, 2.0));  // Not where the map ended, with another heading.
  expect_right(surveyor, surveyor.scan(0, 2.0));
  surveyor.mapper().begin_session();
  const std::string before = surveyor.octomap();
  const SweepResult elsewhere = surveyor.scan_elsewhere();
  EXPECT_EQ(elsewhere.verdict, Verdict::refused);
  EXPECT_NE(elsewhere.reason.find("Not found in the map that it should continue"), std::string::npos);
  const SweepResult beyond = surveyor.scan(8, -1.0);  // Of the same street, but of the other side of the block.
  EXPECT_EQ(beyond.verdict, Verdict::refused) << surveyor.error_m();
  EXPECT_EQ(surveyor.octomap(), before);
  expect_right(surveyor, surveyor.scan(3, -1.0));
  expect_right(surveyor, surveyor.scan(4, -1.0));
}

TEST(Sessions, ARobotThatIsCarriedBackIsFoundThoughItsLastSweepsAreFarAway) {
  Surveyor surveyor;
  for (const std::size_t place : {0u, 1u, 2u, 3u, 4u, 5u, 6u}) expect_right(surveyor, surveyor.scan(place));
  EXPECT_EQ(surveyor.scan_elsewhere().verdict, Verdict::refused);
  expect_right(surveyor, surveyor.scan(0));
}

}  // namespace
}  // namespace scanway
