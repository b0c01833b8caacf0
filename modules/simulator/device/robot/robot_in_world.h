#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/can/can_link.h"
#include "modules/simulator/core/simulator.h"
#include "modules/simulator/device/base/base_emulator.h"
#include "modules/simulator/device/ends/tcp_end.h"
#include "modules/simulator/device/ends/terminal_end.h"
#include "modules/simulator/device/faults/byte_loss.h"
#include "modules/simulator/device/faults/fault_schedule.h"
#include "modules/simulator/device/lms/lms_emulator.h"
#include "modules/simulator/device/pan_tilt/pan_tilt_module.h"
#include "modules/simulator/device/robot/driven_robot.h"
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
/// It drives by what the base is told (DrivenRobot). Whatever goes wrong is asked for (Fault), and happens at its time.
class RobotInWorld {
 public:
  /// `world` and `robot` must outlive this. `stand`: where it begins.
  RobotInWorld(const World& world, const Robot& robot, const Stand& stand, std::uint64_t seed, int thin,
               const DeviceEnds& ends);

  /// The clock runs `speed` times as fast as the host's, and laser and tracker tell their times by the host's.
  void tell_host_time(double speed);

  void add_fault(const Fault& fault) { faults_.add(fault); }
  /// Faults that have come or gone since the last call, a line each.
  std::vector<std::string> take_news() { return std::exchange(news_, {}); }

  /// Waits at most that long for a frame on the bus.
  void wait(int wait_ms) { heard_ = can_->receive(wait_ms); }
  /// Hears what came for the devices, lets them do what is due. What they say now they say of `now`: that is to be the
  /// time, to the millisecond of the fastest of them, so no waiting between the two.
  void run(Utime now);

  /// The truth.
  const Pose& X_world_base() const { return driven_.X_world_base(); }
  double pan_angle(Utime now) const { return pan_.angle(now); }
  /// What keeps it from going where it is told to, ends the sentence "the robot is held: it would stand ..."; empty:
  /// nothing.
  const std::string& obstacle() const { return driven_.obstacle(); }
  std::uint16_t lms_port() const { return lms_end_.port(); }
  /// Scans that it had no time for.
  std::int64_t dropped_scans() const { return lms_.dropped(); }

 private:
  void run_lms(Utime now);
  void run_pan_tilt(Utime now);
  void run_tracker(Utime now);
  void run_base(Utime now);
  void follow_wheels();
  void put();
  void begin_faults(Utime now);
  void set(const FaultSchedule::Change& change, Utime now);
  void set_window(double kept_back);
  TrackerSample sense(std::int64_t sample) const;

  /// A device that may be dark: silent and deaf, until it is switched on.
  struct Power {
    Utime on = 0;
    bool is_on(Utime now) const { return now >= on; }
  };

  const Robot& robot_;
  std::uint64_t seed_;
  DrivenRobot driven_;
  std::uint64_t places_ = 0;  // At which it came to a stand.
  FaultSchedule faults_;
  std::vector<std::string> news_;
  double heading_bias_ = 0.0, tilt_bias_ = 0.0;

  LaserInWorld laser_;
  std::unique_ptr<Tracker> orientation_;
  PanTiltModule pan_, tilt_;
  LmsEmulator lms_;
  TrackerEmulator tracker_;
  BaseEmulator base_;

  Power lms_power_, tracker_power_, base_power_;
  ByteLoss lms_loss_, tracker_loss_, base_loss_;
  TcpEnd lms_end_;
  std::unique_ptr<CanLink> can_;
  std::optional<CanLink::Received> heard_;  // While it waited.
  TerminalEnd tracker_end_, base_end_;
};

}  // namespace scanway::simulator
