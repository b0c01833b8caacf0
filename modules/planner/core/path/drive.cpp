#include "modules/planner/core/path/drive.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/repeatable.h"
#include "modules/planner/core/path/ground.h"

namespace scanway::planning {
namespace {

/// A gain of speed below this is not worth a pose.
constexpr double kLeastGain = 1e-9;

/// From one pose to the next.
struct Part {
  double length_m = 0.0;
  double turn = 0.0;       ///< Radians.
  double direction = 0.0;  ///< 1 forwards, -1 backwards, 0 turning in place.
  double most_m_s = 0.0;
};

Part part_between(const PathPose& a, const PathPose& b, const Robot::Body& body) {
  const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
  Part part;
  part.length_m = std::sqrt(dx * dx + dy * dy);
  part.turn = wrapped(b.heading - a.heading);
  if (part.length_m == 0.0) return part;
  const double middle = a.heading + 0.5 * part.turn;
  part.direction = dx * repeatable::cos(middle) + dy * repeatable::sin(middle) < 0.0 ? -1.0 : 1.0;
  part.most_m_s = body.max_speed_m_s;
  if (part.turn == 0.0) return part;
  const double radius = part.length_m / std::fabs(part.turn);
  part.most_m_s =
      std::min({part.most_m_s, body.max_turn_rate * radius, std::sqrt(body.max_acceleration_m_s2 * radius)});
  return part;
}

/// The speed at each pose that the parts on both sides, starting and braking allow.
std::vector<double> speeds_of(const std::vector<Part>& parts, double acceleration) {
  std::vector<double> speeds(parts.size() + 1, 0.0);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i - 1].direction == parts[i].direction) speeds[i] = std::min(parts[i - 1].most_m_s, parts[i].most_m_s);
  }
  const auto limit = [&](double& speed, double beside, double length) {
    speed = std::min(speed, std::sqrt(beside * beside + 2.0 * acceleration * length));
  };
  for (std::size_t i = 1; i < speeds.size(); ++i) limit(speeds[i], speeds[i - 1], parts[i - 1].length_m);
  for (std::size_t i = speeds.size() - 1; i > 0; --i) limit(speeds[i - 1], speeds[i], parts[i - 1].length_m);
  return speeds;
}

/// Of a turn in place: speeding up for half of it, unless the highest rate is reached.
double turn_time(double turn, const Robot::Body& body) {
  const double angle = std::fabs(turn);
  const double rate = std::min(body.max_turn_rate, std::sqrt(angle * body.max_turn_acceleration));
  return rate > 0.0 ? angle / rate + rate / body.max_turn_acceleration : 0.0;
}

/// Drives the parts one after the other.
class Driver {
 public:
  Driver(const PathPose& start, const Robot::Body& body) : body_(body), poses_{start} {}

  void turn(const PathPose& to, const Part& part) { add(to, poses_.back().time_s + turn_time(part.turn, body_), 0.0); }

  void go(const PathPose& to, const Part& part, double from_speed, double to_speed) {
    const double a = body_.max_acceleration_m_s2;
    const double gained = std::sqrt(0.5 * (from_speed * from_speed + to_speed * to_speed) + a * part.length_m);
    const double peak = std::min(part.most_m_s, gained);
    const PathPose from = poses_.back();
    const auto at = [&](double share) {
      return PathPose{from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m),
                      wrapped(from.heading + share * part.turn)};
    };
    double speed = from_speed, gone = 0.0;
    const auto pass = [&](const PathPose& pose, double place, double next) {
      add(pose, poses_.back().time_s + 2.0 * (place - gone) / (speed + next), part.direction * next);
      gone = place;
      speed = next;
    };
    if (peak > std::max(from_speed, to_speed) + kLeastGain) {
      const double full = (peak * peak - from_speed * from_speed) / (2.0 * a);
      const double braking = part.length_m - (peak * peak - to_speed * to_speed) / (2.0 * a);
      pass(at(full / part.length_m), full, peak);
      if (braking > full + kLeastGain) pass(at(braking / part.length_m), braking, peak);
    }
    pass(to, part.length_m, to_speed);
  }

  std::vector<PathPose> take() { return std::move(poses_); }

 private:
  void add(const PathPose& pose, double time, double speed) {
    poses_.push_back({pose.x_m, pose.y_m, pose.heading, time, speed});
  }

  const Robot::Body& body_;
  std::vector<PathPose> poses_;
};

}  // namespace

double widest_bend(const Robot::Body& body) {
  const double speed = body.max_speed_m_s;
  return std::max(speed / body.max_turn_rate, speed * speed / body.max_acceleration_m_s2);
}

std::vector<PathPose> driven(const std::vector<PathPose>& path, const Robot::Body& body) {
  if (path.empty()) return {};
  std::vector<Part> parts;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) parts.push_back(part_between(path[i], path[i + 1], body));
  const std::vector<double> speeds = speeds_of(parts, body.max_acceleration_m_s2);
  Driver driver(path.front(), body);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].direction == 0.0) driver.turn(path[i + 1], parts[i]);
    if (parts[i].direction != 0.0) driver.go(path[i + 1], parts[i], speeds[i], speeds[i + 1]);
  }
  return driver.take();
}

}  // namespace scanway::planning
