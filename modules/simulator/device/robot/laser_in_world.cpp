#include "modules/simulator/device/robot/laser_in_world.h"

#include <algorithm>
#include <array>

#include "common/parallel/blocks.h"
#include "modules/simulator/core/laser/beam_random.h"

namespace scanway::simulator {
namespace {

constexpr double kAhead_deg = 90.0;  // The scanner's angle of the laser frame's x axis.
constexpr std::size_t kBeamsAtOnce = 128;

}  // namespace

LaserInWorld::LaserInWorld(const World& world, const Robot& robot, std::uint64_t seed, int thin)
    : robot_(robot), seed_(seed), thin_(thin), world_(caster_of(world)) {
  put_robot(Pose::Identity());
}

void LaserInWorld::put_robot(const Pose& X_world_base) {
  X_world_base_ = X_world_base;
  body_ = body_mesh(robot_, X_world_base);
  body_caster_.emplace(std::array<const Mesh*, 1>{&body_});
}

void LaserInWorld::put_people(int count) { people_ = People(world_, X_world_base_.translation(), count, seed_); }

std::uint16_t LaserInWorld::biased(std::uint16_t count, double scale_m) const {
  constexpr double kFirstRange = 16, kLastRange = 65'000;
  if (count == 0 || range_bias_m_ == 0.0) return count;
  return static_cast<std::uint16_t>(std::clamp(count + range_bias_m_ / scale_m, kFirstRange, kLastRange));
}

Pose LaserInWorld::X_base_laser(double pan, double tilt) const {
  Pose turned = Pose::Identity();
  turned.linear() = rotation_about_z(pan) * exp_so3(Eigen::Vector3d(0, tilt, 0));
  return robot_.mounts.base_mount.pose() * robot_.mounts.mount_pan.pose() * turned * robot_.mounts.pan_laser.pose();
}

ScannedLine LaserInWorld::look(const MirrorTurn& turn, const PanTiltModule& pan, const PanTiltModule& tilt) const {
  const BeamModel model(robot_.laser, world_, *body_caster_, people_, window_);
  const auto beams = static_cast<std::size_t>(turn.sector.beams), thin = static_cast<std::size_t>(thin_);
  ScannedLine line{model.range_scale_m() * 1e3, std::vector<std::uint16_t>(beams), std::vector<std::uint8_t>(beams)};
  if (turn.number % thin_ != 0) return line;
  for_blocks((beams + thin - 1) / thin, kBeamsAtOnce, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin * thin; i < beams && i < end * thin; i += thin) {
      const int beam = static_cast<int>(turn.sector.before) + static_cast<int>(i);
      const double before = turn.sector.before + static_cast<double>(i);
      const Utime time = turn.start + static_cast<Utime>(before * turn.beam_period_us);
      const Pose X_world_laser = X_world_base_ * X_base_laser(pan.angle(time), tilt.angle(time));
      const double angle = radians(1) * (turn.sector.start_deg + static_cast<double>(i) * turn.step_deg - kAhead_deg);
      const BeamReading reading = model.read(X_world_laser, angle, static_cast<double>(time),
                                             beam_random(seed_, static_cast<int>(turn.number & 0x7FFFFFFF), beam));
      line.ranges[i] = biased(reading.range_count, model.range_scale_m());
      line.remissions[i] = reading.rssi_count;
    }
  });
  return line;
}

}  // namespace scanway::simulator
