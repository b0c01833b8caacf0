#include "modules/planner/core/path/straighten.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/math/repeatable.h"

namespace scanway::planning {
namespace {

/// So many legs in a row are tried as one; as this is done again and again with what is left, any number becomes one.
constexpr std::size_t kLook = 8;
constexpr int kMostRounds = 16;
/// At first no leg is longer than this, so that a shortcut may begin and end in the middle of a straight run.
constexpr std::int32_t kFirstLength = 8;
/// Of ways that all cost no more than the given one, few legs and little turning are worth this: of a cell's length,
/// and of what the body's outermost point moves.
constexpr double kLegPrice = 1.0;
constexpr double kTurnPrice = 0.5;
constexpr double kRounding = 1e-9;

int step_between(Cell a, Cell b) {
  int step = 0;
  while (kStepX[static_cast<std::size_t>(step)] != b.x - a.x || kStepY[static_cast<std::size_t>(step)] != b.y - a.y)
    ++step;
  return step;
}

std::int32_t reach_of(const Leg& leg) {
  return std::max(std::abs(leg.to.x - leg.from.x), std::abs(leg.to.y - leg.from.y));
}

/// Steps in the same direction at the same heading as one leg.
std::vector<Leg> runs_of(const std::vector<Leg>& steps) {
  std::vector<Leg> runs;
  for (const Leg& step : steps) {
    if (!runs.empty()) {
      Leg& run = runs.back();
      const std::int32_t length = reach_of(run);
      const bool same_way = run.to.x - run.from.x == length * (step.to.x - step.from.x) &&
                            run.to.y - run.from.y == length * (step.to.y - step.from.y);
      if (same_way && run.heading == step.heading && length < kFirstLength) {
        run.to = step.to;
        run.cost += step.cost;
        continue;
      }
    }
    runs.push_back(step);
  }
  return runs;
}

/// The cheapest choice of given legs and of shortcuts over up to kLook of them.
class Shortcuts {
 public:
  Shortcuts(const std::vector<Leg>& legs, const Ground& ground)
      : legs_(legs),
        ground_(ground),
        swing_(ground.has_body() ? ground.body().circumscribed() : 0.0),
        into_(legs.size() + 1) {
    for (const Leg& leg : legs_) rooms_.push_back(ground.turn_room(leg.from));
    double cost = 0.0;
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      if (i > 0)
        cost += turn_cost(*ground.turn(legs_[i].from, legs_[i - 1].heading, legs_[i].heading, rooms_[i]), rooms_[i]);
      cost_before_.push_back(cost);
      cost_after_.push_back(cost += legs_[i].cost);
    }
  }

  std::vector<Leg> best() {
    for (std::size_t to = 1; to <= legs_.size(); ++to) {
      for (std::size_t from = to; from-- > 0 && to - from <= kLook;) add(from, to);
    }
    std::size_t way = cheapest(into_.back());
    std::vector<Leg> chosen;
    for (std::size_t corner = legs_.size(); corner > 0;) {
      const Way& last = into_[corner][way];
      chosen.push_back(last.leg);
      corner = last.from;
      way = last.before;
    }
    std::reverse(chosen.begin(), chosen.end());
    return chosen;
  }

 private:
  /// The cheapest way to a corner whose last leg this is.
  struct Way {
    Leg leg;
    std::size_t from;    ///< The corner where it begins.
    std::size_t before;  ///< The way to that corner, of those into it.
    double cost;
  };

  static std::size_t cheapest(const std::vector<Way>& ways) {
    const auto least = [](const Way& a, const Way& b) { return a.cost < b.cost; };
    return static_cast<std::size_t>(std::min_element(ways.begin(), ways.end(), least) - ways.begin());
  }

  void add(std::size_t from, std::size_t to) {
    const bool is_single = from + 1 == to;
    if (is_single) add(legs_[from], from, to);
    if (is_single && is_aligned(legs_[from])) return;
    if (const std::optional<Leg> leg = shortcut(from, to)) add(*leg, from, to);
  }

  void add(const Leg& leg, std::size_t from, std::size_t to) {
    Way way{leg, from, 0, from == 0 ? 0.0 : std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < into_[from].size(); ++i) {
      const Way& before = into_[from][i];
      const std::optional<double> turn = ground_.turn(leg.from, before.leg.heading, leg.heading, rooms_[from]);
      if (!turn) continue;
      const double cost = before.cost + turn_cost(*turn, rooms_[from]) + kTurnPrice * std::fabs(*turn) * swing_;
      if (cost >= way.cost) continue;
      way.cost = cost;
      way.before = i;
    }
    if (!std::isfinite(way.cost)) return;
    way.cost += leg.cost + kLegPrice;
    into_[to].push_back(way);
  }

  /// From corner to corner in a straight line, if that is allowed and costs no more.
  std::optional<Leg> shortcut(std::size_t from, std::size_t to) const {
    const Cell a = legs_[from].from, b = legs_[to - 1].to;
    const bool backwards = legs_[from].backwards;
    const auto drives_otherwise = [&](std::size_t i) { return legs_[i].backwards != backwards; };
    for (std::size_t i = from; i < to; ++i) {
      if (drives_otherwise(i)) return std::nullopt;
    }
    if (a == b) return std::nullopt;
    const double sign = backwards ? -1.0 : 1.0;
    const Leg leg = ground_.leg(a, b, repeatable::atan2(sign * (b.y - a.y), sign * (b.x - a.x)));
    if (leg.cost > cost_after_[to - 1] - cost_before_[from] + kRounding) return std::nullopt;
    return ground_.is_clear(leg) ? std::optional(leg) : std::nullopt;
  }

  const std::vector<Leg>& legs_;
  const Ground& ground_;
  double swing_;                     ///< From the body's centre to its outermost point.
  std::vector<TurnRoom> rooms_;      ///< Where each leg begins.
  std::vector<double> cost_before_;  ///< Of all up to a leg, with the turn to its heading.
  std::vector<double> cost_after_;   ///< And with the leg.
  std::vector<std::vector<Way>> into_;
};

double cost_of(const std::vector<Leg>& legs, const Ground& ground) {
  double cost = 0.0;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    cost += legs[i].cost;
    if (i == 0) continue;
    const TurnRoom room = ground.turn_room(legs[i].from);
    cost += turn_cost(*ground.turn(legs[i].from, legs[i - 1].heading, legs[i].heading, room), room);
  }
  return cost;
}

}  // namespace

std::vector<Leg> legs_of(const Route& route, const Ground& ground) {
  std::vector<Leg> legs;
  for (std::size_t i = 0; i + 1 < route.places.size(); ++i) {
    const Place& here = route.places[i];
    const Place& next = route.places[i + 1];
    if (here.cell == next.cell) continue;  // A turn: from one leg's heading to the next one's.
    const int heading = here.heading   ? *here.heading
                        : next.heading ? *next.heading
                                       : 2 * step_between(here.cell, next.cell);
    legs.push_back(ground.leg(here.cell, next.cell, angle_of(heading)));
  }
  return legs;
}

std::vector<Leg> straightened(std::vector<Leg> legs, const Ground& ground) {
  legs = runs_of(legs);
  for (int round = 0; round < kMostRounds && !legs.empty(); ++round) {
    std::vector<Leg> better = Shortcuts(legs, ground).best();
    // Legs of their own cost less each; what turning between them costs may spoil it.
    const double gain = cost_of(legs, ground) - cost_of(better, ground);
    if (gain < -kRounding || (better.size() == legs.size() && gain <= kRounding)) break;
    legs = std::move(better);
  }
  return legs;
}

}  // namespace scanway::planning
