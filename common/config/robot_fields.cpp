#include "common/config/robot_fields.h"

#include <array>

#include "common/config/footprint.h"

namespace scanway {
namespace {

constexpr std::array<std::string_view, 2> kEmbodiments = {"footprint", "paper"};
constexpr std::array<std::string_view, 3> kVegetation = {"ignore", "pass", "avoid"};
constexpr std::array<std::string_view, 3> kUnknownPolicies = {"never", "price", "free"};

void describe(Fields& fields, Robot::Body& body) {
  fields.begin_section("body");
  fields.points("footprint_m", body.footprint, footprint_problem);
  fields.number("height_m", body.height_m, {0.01, 100});
  fields.number("climbable_step_m", body.climbable_step_m, {0, 2});
  fields.number("climbable_slope_deg", body.climbable_slope, {0, 60});
  fields.number("max_speed_m_s", body.max_speed_m_s, {0.001, 100});
  fields.number("max_turn_rate_deg_s", body.max_turn_rate, {0.1, 7200});
  fields.number("max_acceleration_m_s2", body.max_acceleration_m_s2, {0.001, 100});
  fields.number("max_turn_acceleration_deg_s2", body.max_turn_acceleration, {0.1, 72000});
  fields.end_section();
}

void describe(Fields& fields, std::string_view name, Mount& mount) {
  fields.begin_section(name);
  fields.numbers("position_m", {mount.position_m.data(), 3}, {-100, 100});
  fields.numbers("roll_pitch_yaw_deg", {mount.roll_pitch_yaw.data(), 3}, {-360, 360});
  fields.end_section();
}

void describe(Fields& fields, Robot::Mounts& mounts) {
  fields.begin_section("mounts");
  describe(fields, "base_mount", mounts.base_mount);
  describe(fields, "mount_pan", mounts.mount_pan);
  describe(fields, "pan_laser", mounts.pan_laser);
  fields.end_section();
}

void describe(Fields& fields, Robot::Laser& laser) {
  fields.begin_section("laser");
  fields.number("range_sigma_m", laser.range_sigma_m, {0.0001, 10});
  fields.number("min_range_m", laser.min_range_m, {0, 1000});
  fields.number("max_range_m", laser.max_range_m, {0.1, 10000});
  fields.number("divergence_mrad", laser.divergence, {0, 200});
  fields.number("field_of_view_deg", laser.field_of_view, {0.1, 360});
  fields.whole_number("beams", laser.beams, {2, 100000});
  fields.number("line_rate_hz", laser.line_rate_hz, {0.1, 10000});
  fields.end_section();
}

void describe(Fields& fields, Robot::Pan& pan) {
  fields.begin_section("pan");
  fields.number("speed_deg_s", pan.speed_rad_s, {0.01, 720});
  fields.number("sweep_deg", pan.sweep, {1, 720});
  fields.end_section();
}

void describe(Fields& fields, Robot::Tracker& tracker) {
  fields.begin_section("tracker");
  fields.number("heading_sigma_deg", tracker.heading_sigma, {0, 180});
  fields.number("tilt_sigma_deg", tracker.tilt_sigma, {0, 90});
  fields.numbers("mount_roll_pitch_yaw_deg", {tracker.mount_roll_pitch_yaw.data(), 3}, {-360, 360});
  fields.end_section();
}

void describe(Fields& fields, Robot::Mapping& mapping) {
  fields.begin_section("mapping");
  fields.number("cloud_voxel_m", mapping.cloud_voxel_m, {0.001, 10});
  fields.number("cost_map_resolution_m", mapping.cost_map_resolution_m, {0.001, 10});
  fields.number("octomap_resolution_m", mapping.octomap_resolution_m, {0.001, 10});
  fields.number("octomap_max_range_m", mapping.octomap_max_range_m, {0.1, 10000});
  fields.boolean("octomap_discretize", mapping.octomap_discretize);
  fields.boolean("paper_projection", mapping.paper_projection);
  fields.enumeration("embodiment", mapping.embodiment, kEmbodiments);
  fields.enumeration("vegetation", mapping.vegetation, kVegetation);
  fields.end_section();
}

void describe(Fields& fields, Robot::Planning& planning) {
  fields.begin_section("planning");
  fields.enumeration("unknown", planning.unknown, kUnknownPolicies);
  fields.number("unknown_price", planning.unknown_price, {0, 1000});
  fields.number("clearance_weight", planning.clearance_weight, {0, 1000});
  fields.end_section();
}

}  // namespace

void describe(Fields& fields, Robot& robot) {
  fields.text("name", robot.name);
  describe(fields, robot.body);
  describe(fields, robot.mounts);
  describe(fields, robot.laser);
  describe(fields, robot.pan);
  describe(fields, robot.tracker);
  describe(fields, robot.mapping);
  describe(fields, robot.planning);
}

}  // namespace scanway
