#include "modules/simulator/device/robot/driven_robot.h"

#include <utility>

#include "common/math/angle.h"
#include "common/math/repeatable.h"

namespace scanway::simulator {
namespace {

constexpr double kAround_m = 2.0;  // What is known of the world to each side of the robot.
constexpr double kMargin_m = 0.05;
constexpr double kAhead_m = 0.01;
constexpr double kAheadTurn = radians(1);

Place place_of(const Pose& X_world_base) {
  const Eigen::Vector3d ahead = X_world_base.linear().col(0), p = X_world_base.translation();
  return {p.x(), p.y(), repeatable::atan2(ahead.y(), ahead.x())};
}

double sign(double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0; }

}  // namespace

DrivenRobot::DrivenRobot(const World& world, const Robot& robot, const Pose& X_world_base, std::uint64_t seed)
    : world_(world), robot_(robot), X_world_base_(X_world_base), slip_(seed) {}

bool DrivenRobot::follow(const WheelMotion& motion) {
  const WheelMotion from = std::exchange(followed_, motion);
  const bool stood = std::exchange(stands_, motion.speed_mm_s == 0.0 && motion.turn_rate_rad_s == 0.0);
  const bool turned = motion.x_mm != from.x_mm || motion.y_mm != from.y_mm || motion.heading != from.heading;
  if (stood && stands_ && !turned) return false;
  const Pose X_world_next = X_world_base_ * slip_.motion_between(from, motion);
  const std::string ahead = problem_at(X_world_next);
  // Where it cannot be already, it may get out.
  if (ahead.empty() || !problem_at(X_world_base_).empty()) {
    X_world_base_ = X_world_next;
    obstacle_.clear();
  } else {
    obstacle_ = ahead;
  }
  if (stands_) settle();
  return true;
}

bool DrivenRobot::is_held(double speed_mm_s, double turn_rate_rad_s) {
  if (speed_mm_s == 0.0 && turn_rate_rad_s == 0.0) return false;
  Pose ahead = Pose::Identity();
  ahead.translation().x() = kAhead_m * sign(speed_mm_s);
  ahead.linear() = rotation_about_z(kAheadTurn * sign(turn_rate_rad_s));
  const std::string problem = problem_at(X_world_base_ * ahead);
  if (problem.empty() || !problem_at(X_world_base_).empty()) return false;
  obstacle_ = problem;
  return true;
}

std::string DrivenRobot::problem_at(const Pose& X_world_base) {
  const Place place = place_of(X_world_base);
  const Eigen::Vector2d centre(place.x, place.y);
  const double reach = robot_.circumscribed_radius_m() + kMargin_m;
  const bool inside = ((centre - known_.low).array() > reach).all() && ((known_.high - centre).array() > reach).all();
  if (!inside) {
    known_ = {centre.array() - kAround_m, centre.array() + kAround_m};
    around_ = make_truth(world_, robot_.body, kTruthCell_m, known_);
  }
  return problem_on(around_, world_, robot_, place);
}

void DrivenRobot::settle() {
  const Stand stand = stand_at(world_, robot_, place_of(X_world_base_));
  if (stand.problem.empty()) X_world_base_ = stand.X_world_base;
}

}  // namespace scanway::simulator
