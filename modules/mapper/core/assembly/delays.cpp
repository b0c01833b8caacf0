#include "modules/mapper/core/assembly/delays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "modules/mapper/core/assembly/support_line.h"

namespace scanway {
namespace {

/// States that share a line, and those around them that it is made of: long against delays, short against the drift of
/// a pan's speed.
constexpr double kBlock_us = 100'000.0, kWindow_us = 1'000'000.0;
constexpr std::size_t kFewest = 25;
constexpr std::size_t kParts = 5;

/// Neighbouring states between which the pan turns one way: x is how far since the first, y microseconds since then.
using Turn = std::vector<PlanePoint>;

/// From `first`, as long as the pan turns the same way.
Turn turn_from(std::span<const PanTiltAngles> angles, std::size_t first, Utime longest_gap_us) {
  Turn turn{{0.0, 0.0}};
  double sign = 0.0;
  for (std::size_t i = first + 1; i < angles.size(); ++i) {
    const double step = angles[i].pan - angles[i - 1].pan;
    if (sign == 0.0) sign = step < 0.0 ? -1.0 : 1.0;
    if (!(step * sign > 0.0) || angles[i].utime - angles[i - 1].utime > longest_gap_us) break;
    turn.push_back(
        {sign * (angles[i].pan - angles[first].pan), static_cast<double>(angles[i].utime - angles[first].utime)});
  }
  return turn;
}

double delay_of(const PlanePoint& told, const StraightLine& line) { return told.y - line.y(told.x); }

double median_delay(std::span<const PlanePoint> told, const StraightLine& line) {
  std::vector<double> delays;
  for (const PlanePoint& state : told) delays.push_back(delay_of(state, line));
  const auto middle = delays.begin() + static_cast<std::ptrdiff_t>(delays.size() / 2);
  std::nth_element(delays.begin(), middle, delays.end());
  return *middle;
}

/// Whether what lies above the line are delays: in every part of the way, and in the block, some state has little. A
/// pan that speeds up or brakes leaves the line for a whole part.
bool is_even(std::span<const PlanePoint> told, std::span<const PlanePoint> block, const StraightLine& line) {
  const double little = median_delay(told, line), way = told.back().x - told.front().x;
  const auto has_little = [&](const PlanePoint& state) { return delay_of(state, line) <= little; };
  std::array<bool, kParts> has_one{};
  for (const PlanePoint& state : told) {
    const auto part = static_cast<std::size_t>((state.x - told.front().x) / way * kParts);
    if (has_little(state)) has_one[std::min(part, kParts - 1)] = true;
  }
  return std::all_of(has_one.begin(), has_one.end(), [](bool one) { return one; }) &&
         std::any_of(block.begin(), block.end(), has_little);
}

std::span<const PlanePoint> between(std::span<const PlanePoint> told, double from_us, double to_us) {
  const auto by_time = [](const PlanePoint& state, double time_us) { return state.y < time_us; };
  const auto begin = std::lower_bound(told.begin(), told.end(), from_us, by_time);
  const auto end = std::lower_bound(begin, told.end(), to_us, by_time);
  return {begin, end};
}

/// The way over time in the block that begins at a moment, if the pan turns evenly around it, or from it on, or up to
/// its end.
std::optional<StraightLine> even_turn_at(std::span<const PlanePoint> told, double block_us) {
  const double earliest = told.front().y, latest = std::max(earliest, told.back().y - kWindow_us);
  const double before = block_us + kBlock_us - kWindow_us;
  const auto block = between(told, block_us, block_us + kBlock_us);
  for (const double wanted : {(block_us + before) / 2, block_us, before}) {
    const double begin = std::clamp(wanted, earliest, latest);
    const auto window = between(told, begin, begin + kWindow_us);
    if (window.size() < kFewest) continue;
    if (const auto line = support_line(window); line && is_even(window, block, *line)) return line;
  }
  return std::nullopt;
}

/// Each state moves on to where the pan was when it came.
void undelay(Turn& turn) {
  const Turn as_told = turn;
  // While the first state is followed by the next the pan may have begun to turn, and ended before the last.
  const std::span told = std::span(as_told).subspan(1, as_told.size() - 2);
  for (std::size_t i = 1; i + 1 < turn.size();) {
    const double block_ends = turn[i].y + kBlock_us;
    const auto line = even_turn_at(told, turn[i].y);
    for (; i + 1 < turn.size() && turn[i].y < block_ends; ++i) {
      if (line) turn[i].x = std::clamp(line->x(turn[i].y), as_told.front().x, as_told.back().x);
    }
  }
}

}  // namespace

std::vector<PanTiltAngles> without_delays(std::vector<PanTiltAngles> angles, Utime longest_gap_us) {
  for (std::size_t first = 0; first + 1 < angles.size();) {
    Turn turn = turn_from(angles, first, longest_gap_us);
    const std::size_t last = first + turn.size() - 1;
    if (turn.size() > kFewest) {
      const double start = angles[first].pan, sign = angles[last].pan < start ? -1.0 : 1.0;
      undelay(turn);
      for (std::size_t i = first + 1; i < last; ++i) angles[i].pan = start + sign * turn[i - first].x;
    }
    first = std::max(last, first + 1);
  }
  return angles;
}

}  // namespace scanway
