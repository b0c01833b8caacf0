#include "modules/planner/core/path/ground.h"

#include <algorithm>
#include <cmath>

#include "common/math/repeatable.h"
#include "modules/planner/core/path/line.h"

namespace scanway::planning {
namespace {

constexpr double kHeadingStep = 2.0 * repeatable::kPi / kHeadings;
/// Headings that are multiples of 22.5 degrees need nothing of the sector beside theirs, whatever the rounding.
constexpr double kSameHeading = 1e-9;
/// A share of a line that only rounding gives to a cell.
constexpr double kTouch = 1e-12;
constexpr double kAligned = 1e-9;
constexpr double kBesideHeading = 1.25;
/// A turn within a sector is looked at in parts of this.
constexpr double kTurnPart = kHeadingStep / 8;

/// Whether the sectors from `from` counter-clockwise on are clear.
bool is_clear(double from, double turn, std::uint16_t clear) {
  const auto first = static_cast<int>(std::floor(from / kHeadingStep + kSameHeading));
  const auto end = static_cast<int>(std::ceil((from + turn) / kHeadingStep - kSameHeading));
  for (int sector = first; sector < end; ++sector) {
    if (((clear >> (sector & (kHeadings - 1))) & 1) == 0) return false;
  }
  return true;
}

}  // namespace

double wrapped(double angle) {
  const double turns = std::floor(angle / (2.0 * repeatable::kPi) + 0.5);
  const double result = angle - turns * 2.0 * repeatable::kPi;
  return result <= -repeatable::kPi ? result + 2.0 * repeatable::kPi : result;
}

std::optional<double> turn_between(double from, double to, const TurnRoom& room) {
  const double left = wrapped(to - from) < 0.0 ? wrapped(to - from) + 2.0 * repeatable::kPi : wrapped(to - from);
  const double right = 2.0 * repeatable::kPi - left;
  const bool left_clear = is_clear(from, left, room.clear);
  const bool right_clear = is_clear(to, right, room.clear);
  if (left_clear && (left <= right || !right_clear)) return left;
  if (right_clear) return -right;
  return std::nullopt;
}

bool is_aligned(const Leg& leg) {
  const Eigen::Vector2d way = (leg.end() - leg.start()).normalized();
  const double beside = way.x() * repeatable::sin(leg.heading) - way.y() * repeatable::cos(leg.heading);
  return std::fabs(beside) < kAligned;
}

double turn_cost(double turn, const TurnRoom& room) { return std::fabs(turn) / kHeadingStep * room.price; }

double Ground::weight(Cell cell) const {
  const std::uint16_t field = terrain_->field(terrain_->frame().index(cell));
  return static_cast<double>(Terrain::weight_of(field)) / terrain_->weight_one();
}

bool Ground::is_free(Cell cell) const {
  return Terrain::class_of(terrain_->field(terrain_->frame().index(cell))) != Terrain::Class::blocked;
}

Leg Ground::leg(Cell from, Cell to, double heading) const {
  Leg leg{from, to, heading, false, 0.0};
  const Eigen::Vector2d way = leg.end() - leg.start();
  leg.backwards = way.x() * repeatable::cos(heading) + way.y() * repeatable::sin(heading) < 0.0;
  leg.cost = (leg.backwards ? 2.0 : 1.0) * cost_of(leg.start(), leg.end());
  if (!is_aligned(leg)) leg.cost *= kBesideHeading;
  return leg;
}

double Ground::cost_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  double mean = 0.0;
  for_cells_on(a, b, [&](Cell cell, double share) { mean += share * weight(cell); });
  return mean * (b - a).norm();
}

double Ground::dearest_on(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  double dearest = 0.0;
  for_cells_on(a, b, [&](Cell cell, double share) {
    if (share > kTouch) dearest = std::max(dearest, weight(cell));
  });
  return dearest;
}

bool Ground::is_clear(const Leg& leg) const {
  if (!has_body()) return is_line_free(leg.start(), leg.end());
  // Backwards the body covers what it covers on its way back.
  const Cell rear = leg.backwards ? leg.to : leg.from;
  const Cell front = leg.backwards ? leg.from : leg.to;
  return terrain_->is_clear(body().sweeping(front.x - rear.x, front.y - rear.y), terrain_->frame().index(rear));
}

bool Ground::is_line_free(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  bool free = true;
  Cell before = cell_of(a);
  for_cells_on(a, b, [&](Cell cell, double) {
    const bool across = cell.x != before.x && cell.y != before.y;
    free = free && is_free(cell) && (!across || (is_free({before.x, cell.y}) && is_free({cell.x, before.y})));
    before = cell;
  });
  return free;
}

bool Ground::is_clear(const Eigen::Vector2d& a, double heading_a, const Eigen::Vector2d& b, double heading_b,
                      double radius) const {
  const Cell middle = cell_of(a);
  const double half_turn = 0.5 * wrapped(heading_b - heading_a);
  // No point of the body is further from the curve's centre, and 1 - cos(x) is at most x^2 / 2.
  const double bulge = (radius + body().circumscribed()) * 0.5 * half_turn * half_turn;
  Polygon points;
  for (const auto& [at, heading] : {std::pair(a, heading_a), std::pair(b, heading_b)}) {
    for (const auto& corner : placed(body().footprint(), repeatable::cos(heading), repeatable::sin(heading),
                                     at.x() - middle.x, at.y() - middle.y)) {
      for (const double x : {-bulge, bulge}) {
        for (const double y : {-bulge, bulge}) points.emplace_back(corner + Eigen::Vector2d(x, y));
      }
    }
  }
  return terrain_->is_clear(cells_under_hull(std::move(points)), terrain_->frame().index(middle));
}

TurnRoom Ground::turn_room(Cell cell) const {
  const std::uint32_t index = terrain_->frame().index(cell);
  TurnRoom room;
  if (Terrain::class_of(terrain_->field(index)) != Terrain::Class::tight) return room;
  room.price = weight(cell);
  room.clear = 0;
  for (int heading = 0; heading < kHeadings; ++heading) {
    if (terrain_->can_turn(index, heading)) room.clear |= static_cast<std::uint16_t>(1u << heading);
  }
  return room;
}

std::optional<double> Ground::turn(Cell at, double from, double to, const TurnRoom& room) const {
  if (const auto turn = turn_between(from, to, room)) return turn;
  const double turn = wrapped(to - from);
  if (std::fabs(turn) >= kHeadingStep) return std::nullopt;
  const int parts = static_cast<int>(std::ceil(std::fabs(turn) / kTurnPart));
  const Eigen::Vector2d middle(at.x, at.y);
  for (int i = 0; i < parts; ++i) {
    if (!is_clear(middle, from + turn * i / parts, middle, from + turn * (i + 1) / parts, 0.0)) return std::nullopt;
  }
  return turn;
}

}  // namespace scanway::planning
