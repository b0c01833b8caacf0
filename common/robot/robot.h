#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace scanway {

/// How the robot's body makes cells near an obstacle dear.
enum class Embodiment {
  footprint,  ///< Lethal within the inscribed radius; falls off with the clearance beyond the circumscribed radius.
  paper,      ///< The paper's: exp(-(dx^2 + dy^2) / 2) in cells, accumulated over all obstacles within 29 cells.
};

/// What a plan may do with cells that nobody has seen.
enum class UnknownPolicy { never, price, free };

/// The robot as its file describes it (launch/robots/*.yaml, docs/robot-file.md): SI units and radians.
struct Robot {
  std::string name = "era_mobi";

  struct Body {
    /// Corners in order, counter-clockwise, in `base`, metres.
    std::vector<Eigen::Vector2d> footprint = {{0.20, 0.205}, {-0.20, 0.205}, {-0.20, -0.205}, {0.20, -0.205}};
    double height_m = 1.5;           ///< Nothing above this over the ground can be hit (with what stands on the robot).
    double climbable_step_m = 0.02;  ///< Steps up to this are driven over.
    double climbable_slope = 0.2618;  ///< Radians (15 degrees).
    double max_speed_m_s = 2.0;
  } body;

  struct Laser {
    double range_sigma_m = 0.01;
    double max_range_m = 80.0;
    double min_range_m = 0.3;         ///< Nearer returns are the robot itself or a no-return mark.
    double divergence = 0.0047;       ///< Full angle of a beam, radians.
  } laser;

  struct Tracker {
    double heading_sigma = 0.0873;  ///< Radians (5 degrees).
    double tilt_sigma = 0.0087;     ///< Radians (0.5 degrees), roll and pitch each.
  } tracker;

  struct Mapping {
    double cloud_voxel_m = 0.01;
    double cost_map_resolution_m = 0.01;
    double octomap_resolution_m = 0.1;
    double octomap_max_range_m = 20.0;
    bool octomap_discretize = true;
    bool paper_projection = false;  ///< The paper's cost map: a cell without an obstacle point is free.
    Embodiment embodiment = Embodiment::footprint;
  } mapping;

  struct Planning {
    UnknownPolicy unknown = UnknownPolicy::never;
    double unknown_price = 4.0;      ///< Under `price`: what a metre of unknown costs more than a metre of free.
    double clearance_weight = 3.0;   ///< What a metre at cost 1.0 costs more than a metre at cost 0.
  } planning;

  /// Radius of the largest circle about the robot's centre within the footprint, metres.
  double inscribed_radius_m() const;
  /// Radius of the smallest circle about the robot's centre around the footprint, metres.
  double circumscribed_radius_m() const;
};

}  // namespace scanway
