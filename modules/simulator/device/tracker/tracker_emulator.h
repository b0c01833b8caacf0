#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "common/time/utime.h"
#include "modules/simulator/device/tracker/xbus.h"

namespace scanway::simulator {

/// What the tracker measures at one moment.
struct TrackerSample {
  Eigen::Quaterniond q_world_sensor = Eigen::Quaterniond::Identity();  ///< World: x east, y north, z up.
  Eigen::Vector3d acceleration{0.0, 0.0, 9.81};                        ///< m/s^2, of the ground's push, in the sensor.
  Eigen::Vector3d rate_of_turn = Eigen::Vector3d::Zero();              ///< rad/s, in the sensor.
  Eigen::Vector3d magnetic_field{0.0, 1.0, 0.0};                       ///< In the sensor; length 1 where calibrated.
};

/// An MTi of the current series (MTData2) as the host hears it: bytes in, bytes out, its own clock as an argument
/// (microseconds since it was switched on). The older MTData is not spoken.
class TrackerEmulator {
 public:
  using Sense = std::function<TrackerSample(std::int64_t sample, Utime time)>;

  explicit TrackerEmulator(Sense sense) : sense_(std::move(sense)) {}

  /// Its answers.
  XbusBytes receive(std::span<const std::uint8_t> bytes, Utime now);
  /// What it sends unasked by now: the greeting after it was switched on, and measurements.
  XbusBytes tick(Utime now);

  /// Lives `speed` seconds in one second of the host, and from now on tells its times by the host's.
  void tell_host_time(double speed) { speed_ = speed; }

  /// Switched off and on: its clock and its counter begin anew, its settings stay.
  void reboot();

  bool measuring() const { return state_ == State::measuring; }

 private:
  enum class State : std::uint8_t { off, waking, configuring, measuring };
  struct Output {
    std::uint16_t id, rate_hz;
  };

  XbusBytes answer(const XbusRequest& request, Utime now);
  XbusBytes answer_in_configuration(const XbusRequest& request);
  XbusBytes set_output(const XbusBytes& list);
  XbusBytes output_list() const;
  XbusBytes configuration() const;
  XbusBytes measure(Utime time);
  void append_output(XbusBytes& data, const Output& output, const TrackerSample& sample, Utime time) const;
  void start_measuring(Utime now);
  std::int64_t rate_hz() const;

  Sense sense_;
  XbusRequests requests_;
  State state_ = State::off;
  Utime woke_ = 0, began_ = 0;
  std::int64_t sample_ = 0;  // Since it began to measure.
  std::uint16_t counter_ = 0;
  double speed_ = 1.0;
  std::vector<Output> outputs_ = {{0x1020, 0xFFFF}, {0x1060, 0xFFFF}, {0x2010, 100}, {0xE020, 0xFFFF}};
};

}  // namespace scanway::simulator
