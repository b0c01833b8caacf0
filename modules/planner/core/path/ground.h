#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "modules/planner/core/body/terrain.h"

namespace scanway::planning {

/// A straight drive from the middle of one cell to that of another, at one heading.
struct Leg {
  Cell from;
  Cell to;
  double heading = 0.0;  ///< Radians.
  bool backwards = false;
  double cost = 0.0;  ///< In straight steps between cells of weight one; more beside its heading (Ground::leg).

  Eigen::Vector2d start() const { return {from.x, from.y}; }
  Eigen::Vector2d end() const { return {to.x, to.y}; }
};

/// How the body can turn in place somewhere.
struct TurnRoom {
  std::uint16_t clear = 0xFFFF;  ///< Bit k: from heading k to k + 1.
  double price = 0.0;            ///< Of 22.5 degrees, as a leg's cost.
};

/// The turn from one heading to another, radians, positive counter-clockwise: the shorter way round if it is clear,
/// else the longer one; nothing when neither is.
std::optional<double> turn_between(double from, double to, const TurnRoom& room);
/// Whether the body drives the way that it faces, or backwards; a route's steps may be up to 22.5 degrees beside it.
bool is_aligned(const Leg& leg);
/// What a turn costs.
double turn_cost(double turn, const TurnRoom& room);

/// An angle in (-pi, pi].
double wrapped(double angle);

/// A terrain for bodies that drive along any straight line and turn by any angle. Points are in cells.
class Ground {
 public:
  explicit Ground(Terrain& terrain) : terrain_(&terrain) {}

  bool has_body() const { return terrain_->options().mode == BodyMode::footprint; }
  const Body& body() const { return terrain_->body(); }
  const Terrain& terrain() const { return *terrain_; }

  /// A leg at this heading, with its cost; whether the body passes is not asked. No wheel drives beside its heading, so
  /// such a leg costs a quarter more here than in the search.
  Leg leg(Cell from, Cell to, double heading) const;
  /// The weighted length of a segment: what the search charges for it where it is a way of the search's.
  double cost_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// What a length costs at most along the segment a-b, in parts of weight one.
  double dearest_on(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;

  /// Whether the body is clear all the way along a straight leg whose heading is its direction, or, backwards,
  /// opposite.
  bool is_clear(const Leg& leg) const;
  /// Whether it is clear from one pose to another while it moves and turns evenly, along any curve that leaves the
  /// chord by no more than that of a circle of this radius about another point. The turn is small.
  bool is_clear(const Eigen::Vector2d& a, double heading_a, const Eigen::Vector2d& b, double heading_b,
                double radius) const;
  TurnRoom turn_room(Cell cell) const;
  /// turn_between(), and turns of less than 22.5 degrees that are clear though all of their sector is not.
  std::optional<double> turn(Cell at, double from, double to, const TurnRoom& room) const;

 private:
  bool is_free(Cell cell) const;
  bool is_line_free(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  double weight(Cell cell) const;

  Terrain* terrain_;
};

}  // namespace scanway::planning
