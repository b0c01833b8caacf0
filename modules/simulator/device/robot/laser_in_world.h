#pragma once

#include <cstdint>
#include <optional>

#include "modules/simulator/core/simulator.h"
#include "modules/simulator/device/lms/lms_emulator.h"
#include "modules/simulator/device/pan_tilt/pan_tilt_module.h"

namespace scanway::simulator {

/// What the scanner on the pan-tilt sees, beam by beam: mirror, pan and tilt turn at the same time.
class LaserInWorld {
 public:
  /// `world` and `robot` must outlive this. `thin`: only every thin-th turn of the mirror, and of it every thin-th
  /// beam, sees anything; the others have no return.
  LaserInWorld(const World& world, const Robot& robot, std::uint64_t seed, int thin);

  void put_robot(const Pose& X_world_base);
  /// So many walk about near where the robot is now.
  void put_people(int count);
  /// How much light its window lets through, out and in.
  void set_window(double share) { window_ = share; }
  void set_range_bias(double metres) { range_bias_m_ = metres; }
  /// `turn` by the clock that pan and tilt have.
  ScannedLine look(const MirrorTurn& turn, const PanTiltModule& pan, const PanTiltModule& tilt) const;

 private:
  Pose X_base_laser(double pan, double tilt) const;
  std::uint16_t biased(std::uint16_t count, double scale_m) const;

  const Robot& robot_;
  std::uint64_t seed_;
  int thin_;
  RayCaster world_;
  Pose X_world_base_ = Pose::Identity();
  Mesh body_;
  std::optional<RayCaster> body_caster_;
  People people_;
  double window_ = 1.0, range_bias_m_ = 0.0;
};

}  // namespace scanway::simulator
