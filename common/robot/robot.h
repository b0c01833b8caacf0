#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "common/geometry/pose.h"
#include "common/math/angle.h"

namespace scanway {

/// How the robot's body makes cells near an obstacle dear.
enum class Embodiment {
  footprint,  ///< Lethal within the inscribed radius; falls off with the clearance beyond the circumscribed radius.
  paper,      ///< The paper's: exp(-(dx^2 + dy^2) / 2) in cells, accumulated over all obstacles within 29 cells.
};

/// What is made of low, soft vegetation, which a scan tells from hard ground by its remission and its roughness.
enum class Vegetation {
  ignore,  ///< Nothing: it is not told from other ground.
  pass,    ///< The robot drives through it: returns of what is no higher than grass are no obstacles there.
  avoid,   ///< The robot stays off it: soft ground is occupied.
};

/// What a plan may do with cells that nobody has seen.
enum class UnknownPolicy { never, price, free };

/// Where one frame sits in the frame before it: first the shift, then yaw, pitch, roll about the moved axes.
struct Mount {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d roll_pitch_yaw = Eigen::Vector3d::Zero();  ///< Radians.
  bool operator==(const Mount&) const = default;

  Pose pose() const;
};

/// The robot as its file describes it (launch/robots/*.yaml, docs/robot-file.md): SI units and radians.
struct Robot {
  std::string name = "era_mobi";

  struct Body {
    /// Corners in order, counter-clockwise, in `base`, metres.
    std::vector<Eigen::Vector2d> footprint = {{0.20, 0.205}, {-0.20, 0.205}, {-0.20, -0.205}, {0.20, -0.205}};
    double height_m = 1.5;           ///< Nothing above this over the ground can be hit (with what stands on the robot).
    double climbable_step_m = 0.02;  ///< Steps up to this are driven over.
    double climbable_slope = radians(15);  ///< Radians.
    double max_speed_m_s = 2.0;
    double max_turn_rate = radians(360);          ///< Radians a second.
    double max_acceleration_m_s2 = 1.0;           ///< Also sideways, in a bend.
    double max_turn_acceleration = radians(360);  ///< Radians a second, a second.
    bool operator==(const Body&) const = default;
  } body;

  /// From the base to the laser, one frame after the other (docs/conventions.md).
  struct Mounts {
    Mount base_mount{{0.0, 0.0, 0.15}, {0.0, 0.0, 0.0}};        ///< X_base_mount: on top of the body.
    Mount mount_pan;                                            ///< X_mount_pan, with the pan at its zero.
    Mount pan_laser{{0.0, 0.0, 0.0}, {radians(90), 0.0, 0.0}};  ///< X_pan_laser: the laser scans a vertical plane.
    bool operator==(const Mounts&) const = default;
  } mounts;

  struct Laser {
    double range_sigma_m = 0.01;
    double max_range_m = 80.0;
    double min_range_m = 0.3;             ///< Nearer returns are the robot itself or a no-return mark.
    double divergence = 0.0047;           ///< Full angle of a beam, radians.
    double field_of_view = radians(190);  ///< Radians.
    int beams = 1141;                     ///< A line, evenly spread over the field of view.
    double line_rate_hz = 25.0;           ///< Scan lines a second.
    bool operator==(const Laser&) const = default;
  } laser;

  struct Pan {
    double speed_rad_s = radians(3);  ///< During a sweep.
    double sweep = radians(360);      ///< Radians from the start to the end of a sweep.
    bool operator==(const Pan&) const = default;
  } pan;

  struct Tracker {
    double heading_sigma = radians(5);                               ///< Radians.
    double tilt_sigma = radians(0.5L);                               ///< Radians, roll and pitch each.
    Eigen::Vector3d mount_roll_pitch_yaw = Eigen::Vector3d::Zero();  ///< How it sits on the base, radians; see Mount.
    /// Rotates a vector of the tracker into the base.
    Eigen::Matrix3d R_base_tracker() const { return Mount{{0.0, 0.0, 0.0}, mount_roll_pitch_yaw}.pose().linear(); }
    bool operator==(const Tracker&) const = default;
  } tracker;

  struct Mapping {
    double cloud_voxel_m = 0.01;
    double cost_map_resolution_m = 0.01;
    double octomap_resolution_m = 0.1;
    double octomap_max_range_m = 20.0;
    bool octomap_discretize = true;
    bool paper_projection = false;  ///< The paper's cost map: a cell without an obstacle point is free.
    Embodiment embodiment = Embodiment::footprint;
    Vegetation vegetation = Vegetation::ignore;
    bool operator==(const Mapping&) const = default;
  } mapping;

  struct Planning {
    UnknownPolicy unknown = UnknownPolicy::never;
    double unknown_price = 4.0;     ///< Under `price`: what a metre of unknown costs more than a metre of free.
    double clearance_weight = 3.0;  ///< What a metre at cost 1.0 costs more than a metre at cost 0.
    bool operator==(const Planning&) const = default;
  } planning;

  bool operator==(const Robot&) const = default;

  /// Radius of the largest circle about the robot's centre within the footprint, metres.
  double inscribed_radius_m() const;
  /// Radius of the smallest circle about the robot's centre around the footprint, metres.
  double circumscribed_radius_m() const;
};

}  // namespace scanway
