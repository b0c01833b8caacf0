#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "common/cloud/beam_fan.h"
#include "common/cloud/point_cloud.h"
#include "common/time/utime.h"

namespace scanway {

/// One 360-degree scan, taken by a robot that stands still. The sweep's frame is where its points are expressed: for
/// imported clouds the scan's own frame (sensor at the origin, z up), for the robot's sweeps `base`.
struct Sweep {
  std::string name;
  Utime utime = 0;                           ///< When the last of its points was measured.
  PointCloud cloud;                          ///< In the sweep's frame.
  std::vector<std::int32_t> time_offset_us;  ///< Each point's time relative to utime (<= 0); empty if not known.
  std::vector<BeamFan> no_return;            ///< Beams that met nothing; empty if it is not known which did.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< The sensor's centre in the sweep's frame, metres.
  std::optional<double> sensor_height_m;             ///< Of the sensor's centre above the ground below it, if known.
  /// The tracker's orientation of the sweep's frame in a world with z up along gravity; its heading has an arbitrary
  /// zero that is the same for all sweeps of a log. Absent without a tracker.
  std::optional<Eigen::Quaterniond> R_world_sweep;
};

}  // namespace scanway
