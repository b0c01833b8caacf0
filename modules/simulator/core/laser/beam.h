#pragma once

#include <cstdint>

#include "common/random/random.h"
#include "common/robot/robot.h"
#include "modules/simulator/core/people/people.h"
#include "modules/simulator/core/ray/ray_caster.h"

namespace scanway::simulator {

/// What the scanner says of one beam, as it counts. range_count 0: no return.
struct BeamReading {
  std::uint16_t range_count = 0;
  std::uint8_t rssi_count = 0;
  Label label = Label::nothing;  ///< Of what sent back most of the light.
};

/// The optics of the LMS500. A beam is a cone: where its footprint lies on one plane, the range is that of its axis;
/// elsewhere twelve rays sample the cone, and what comes back from the nearest surfaces that are too close to each
/// other to be told apart is averaged: a mixed pixel. Too little light is no return.
class BeamModel {
 public:
  /// All must outlive this. `body`: the robot itself, which no ray passes. `window`: how much of the light comes
  /// through it, out and in; 1: it is clean.
  BeamModel(const Robot::Laser& laser, const RayCaster& world, const RayCaster& body, const People& people,
            double window = 1.0);

  /// `X_world_laser`: where the laser is as the beam leaves, which is at `time_us` of the people's clock; `angle`: its
  /// angle in the scan plane.
  BeamReading read(const Eigen::Isometry3d& X_world_laser, double angle, double time_us, Random random) const;

  /// Metres of a count: a 16-bit count of millimetres ends at 65 m.
  double range_scale_m() const { return range_scale_m_; }

 private:
  struct Echo;
  RayCaster::FourHits cast(const Eigen::Vector3d& origin, const RayCaster::Four& directions, double time_us) const;
  BeamReading reading_of(const Echo& echo, Random& random) const;

  const Robot::Laser& laser_;
  const RayCaster& world_;
  const RayCaster& body_;
  const People& people_;
  double window_;
  double range_scale_m_;
};

/// The least power that the scanner detects, for a white sheet at 1 m: 10 % remission is seen up to 40 m.
constexpr double kLeastPower = 0.1 / (40.0 * 40.0);

}  // namespace scanway::simulator
