#include "modules/planner/core/path/poses.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/math/angle.h"
#include "common/math/repeatable.h"

namespace scanway::planning {
namespace {

/// From pose to pose of an arc.
constexpr double kArcPart = radians(2);
/// A turn in place is told in parts of no more than this.
constexpr double kMostTurn = radians(120);
/// Sharper corners are turned in place.
constexpr double kSharpest = radians(120);
/// Shorter arcs are not worth having, in cells from the corner.
constexpr double kLeastRounding = 2.0;
constexpr double kStraight = 1e-9;
constexpr double kRounding = 1e-9;

Eigen::Vector2d direction_of(const Leg& leg) { return (leg.end() - leg.start()).normalized(); }

/// A corner between two legs, to be rounded.
class Corner {
 public:
  Corner(const Leg& before, const Leg& behind)
      : before_(before), behind_(behind), in_(direction_of(before)), out_(direction_of(behind)) {
    const double cross = in_.x() * out_.y() - in_.y() * out_.x(), dot = in_.dot(out_);
    turn_ = repeatable::atan2(cross, dot);
    tangent_ = std::fabs(cross) / (1.0 + dot);
  }

  bool can_be_round() const {
    return before_.backwards == behind_.backwards && is_aligned(before_) && is_aligned(behind_) &&
           std::fabs(turn_) > kStraight && std::fabs(turn_) < kSharpest;
  }
  /// The arc of this radius from leg to leg; each leg lends half of itself.
  double most_radius() const {
    const double half =
        0.5 * std::min((before_.end() - before_.start()).norm(), (behind_.end() - behind_.start()).norm());
    return half / tangent_;
  }
  double cut_off(double radius) const { return radius * tangent_; }

  std::vector<CellPose> arc(double radius) const {
    const double travel = repeatable::atan2(in_.y(), in_.x());
    const double side = turn_ < 0.0 ? -radius : radius;
    const Eigen::Vector2d corner = before_.end();
    const Eigen::Vector2d begin = corner - in_ * cut_off(radius);
    const int parts = static_cast<int>(std::ceil(std::fabs(turn_) / kArcPart));
    std::vector<CellPose> poses = {{begin, before_.heading}};
    for (int i = 1; i < parts; ++i) {
      const double turned = turn_ * i / parts;
      const double now = travel + turned;
      const Eigen::Vector2d moved(repeatable::sin(now) - in_.y(), in_.x() - repeatable::cos(now));
      poses.push_back({begin + side * moved, wrapped(before_.heading + turned)});
    }
    poses.push_back({corner + out_ * cut_off(radius), behind_.heading});
    return poses;
  }

 private:
  const Leg& before_;
  const Leg& behind_;
  Eigen::Vector2d in_, out_;
  double turn_;     ///< Radians, positive to the left.
  double tangent_;  ///< Of half the turn.
};

bool is_clear(const std::vector<CellPose>& arc, double radius, const Ground& ground) {
  for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
    if (!ground.is_clear(arc[i].at, arc[i].heading, arc[i + 1].at, arc[i + 1].heading, radius)) return false;
  }
  return true;
}

double cost_of(const std::vector<CellPose>& arc, bool backwards, const Ground& ground) {
  double cost = 0.0;
  for (std::size_t i = 0; i + 1 < arc.size(); ++i) cost += ground.cost_of(arc[i].at, arc[i + 1].at);
  return backwards ? 2.0 * cost : cost;
}

/// The widest arc of a few that serves instead of the corner; empty: none does.
std::vector<CellPose> rounded(const Leg& before, const Leg& behind, const Ground& ground, double most_radius) {
  if (most_radius <= 0.0 || !ground.has_body()) return {};
  const Corner corner(before, behind);
  if (!corner.can_be_round()) return {};
  const TurnRoom room = ground.turn_room(before.to);
  const double turning = turn_cost(*ground.turn(before.to, before.heading, behind.heading, room), room);
  for (double radius = std::min(most_radius, corner.most_radius()); corner.cut_off(radius) >= kLeastRounding;
       radius *= 0.5) {
    std::vector<CellPose> arc = corner.arc(radius);
    const double there = ground.cost_of(arc.front().at, before.end()) + ground.cost_of(before.end(), arc.back().at);
    const double most = (before.backwards ? 2.0 : 1.0) * there + turning + kRounding;
    if (cost_of(arc, before.backwards, ground) <= most && is_clear(arc, radius, ground)) return arc;
  }
  return {};
}

void add_turn(const Leg& before, const Leg& behind, const Ground& ground, std::vector<CellPose>& poses) {
  poses.push_back({before.end(), before.heading});
  if (before.heading == behind.heading) return;
  const double turn = *ground.turn(before.to, before.heading, behind.heading, ground.turn_room(before.to));
  const int parts = static_cast<int>(std::ceil(std::fabs(turn) / kMostTurn));
  for (int i = 1; i < parts; ++i) poses.push_back({before.end(), wrapped(before.heading + turn * i / parts)});
  poses.push_back({before.end(), behind.heading});
}

}  // namespace

std::vector<CellPose> poses_of(const std::vector<Leg>& legs, const Ground& ground, double most_radius) {
  std::vector<CellPose> poses;
  if (legs.empty()) return poses;
  poses.push_back({legs.front().start(), legs.front().heading});
  for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
    const std::vector<CellPose> arc = rounded(legs[i], legs[i + 1], ground, most_radius);
    // Two arcs may share the middle of a leg.
    const bool shared = !arc.empty() && (arc.front().at - poses.back().at).norm() < kRounding;
    poses.insert(poses.end(), arc.begin() + (shared ? 1 : 0), arc.end());
    if (arc.empty()) add_turn(legs[i], legs[i + 1], ground, poses);
  }
  poses.push_back({legs.back().end(), legs.back().heading});
  return poses;
}

}  // namespace scanway::planning
