#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "common/can/can_link.h"
#include "modules/simulator/core/simulator.h"
#include "modules/simulator/device/base/base_emulator.h"
#include "modules/simulator/device/ends/tcp_end.h"
#include "modules/simulator/device/ends/terminal_end.h"
#include "modules/simulator/device/lms/lms_emulator.h"
#include "modules/simulator/device/pan_tilt/pan_tilt_module.h"
#include "modules/simulator/device/robot/laser_in_world.h"
#include "modules/simulator/device/tracker/tracker_emulator.h"

namespace scanway::simulator {

/// Where the host finds the robot's devices.
struct DeviceEnds {
  std::uint16_t lms_port = 2112;  ///< On the loopback interface; 0: any free one.
  std::string can;                ///< "unix:/path", or an interface.
  std::string tracker, base;      ///< Links to pseudo-terminals.
};

/// The robot in a world with its four devices, as the host's cables end. The clock of all of them is the argument:
/// microseconds since they were switched on.
///
/// It drives by what the base is told, and stands on the ground where it comes to a stand; on its way it keeps the
/// slope of the last place. Its wheels do not slip, and nothing stops it but its commands.
class RobotInWorld {
 public:
  /// `world` and `robot` must outlive this. `stand`: where it begins.
  RobotInWorld(const World& world, const Robot& robot, const Stand& stand, std::uint64_t seed, int thin,
               const DeviceEnds& ends);

  /// The clock runs `speed` times as fast as the host's, and laser and tracker tell their times by the host's.
  void tell_host_time(double speed);

  /// Hears what came for the devices, lets them do what is due, waits at most `wait_ms` for the bus.
  void run(Utime now, int wait_ms);

  /// The truth.
  const Pose& X_world_base() const { return X_world_base_; }
  double pan_angle(Utime now) const { return pan_.angle(now); }
  /// What is wrong with where it stands, ends the sentence "the robot stands ..."; empty: nothing.
  const std::string& problem() const { return problem_; }
  std::uint16_t lms_port() const { return lms_end_.port(); }

 private:
  void run_lms(Utime now);
  void run_pan_tilt(Utime now, int wait_ms);
  void run_tracker(Utime now);
  void run_base(Utime now);
  void follow_wheels();
  void put(const Pose& X_world_base);
  TrackerSample sense(std::int64_t sample) const;

  const World& world_;
  const Robot& robot_;
  std::uint64_t seed_;
  Pose X_world_base_;
  Pose X_world_start_;  // Where the wheels' motion began to count: on the ground, at the last stand.
  WheelMotion at_start_;
  bool stands_ = true;
  std::string problem_;

  LaserInWorld laser_;
  std::unique_ptr<Tracker> orientation_;
  PanTiltModule pan_, tilt_;
  LmsEmulator lms_;
  TrackerEmulator tracker_;
  BaseEmulator base_;

  TcpEnd lms_end_;
  std::unique_ptr<CanLink> can_;
  TerminalEnd tracker_end_, base_end_;
};

}  // namespace scanway::simulator
