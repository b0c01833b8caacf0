#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "common/bus/bus.h"
#include "common/bytes/counter_gap.h"
#include "common/robot/robot.h"
#include "modules/xsens_bridge/device/tracker_device.h"

namespace scanway::xsens {

/// How good the robot file says that the tracker's orientation is.
TrackerAccuracy accuracy_of(const Robot::Tracker& tracker);

/// The tracker on the bus: IMU out, of the base, wherever the tracker sits on it.
class XsensNode {
 public:
  /// `bus` and `device` must outlive this.
  XsensNode(Bus& bus, TrackerDevice& device, const Robot::Tracker& tracker);

  /// Waits at most `timeout_ms` for the tracker and publishes what came. Returns what is wrong and was not said yet,
  /// a line each.
  std::vector<std::string> run(int timeout_ms);
  /// What the tracker is, once it is set up when its first orientation came; else empty.
  std::string take_welcome();

  /// What people should know now, in one line; empty: all is well.
  std::string summary() const;
  /// What was lost or bad so far, and how good the orientation is, by name.
  std::map<std::string, std::int64_t> counters() const;

 private:
  void notice_restart();
  void take(const TimedReading& timed);
  void publish(const TimedReading& timed, const Eigen::Quaterniond& q_world_sensor);

  Bus& bus_;
  TrackerDevice& device_;
  const Eigen::Quaterniond q_base_sensor_;
  CounterGap gap_;
  std::int64_t number_ = 0;  // Of the newest message: the tracker's counter, counted on over its wraps.
  std::int64_t lost_ = 0;
  std::int64_t orientations_ = 0;
  std::int64_t unhealthy_ = 0;
  TrackerReading newest_;  // That holds an orientation.
  std::int64_t starts_ = 0;
  bool works_ = false;  // An orientation came since the tracker was set up.
  std::string welcome_;
  std::string complaint_;  // The last one since then.
};

}  // namespace scanway::xsens
