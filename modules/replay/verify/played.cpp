#include "modules/replay/verify/played.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/files/printable.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/replay/verify/sweep_list.h"
#include "scanway/goal_t.hpp"
#include "scanway/sweep_mark_t.hpp"
#include "scanway/sweep_t.hpp"

namespace scanway {
namespace {

/// What the sweep used of IMU; 0: nothing.
std::int64_t imu_used(const sweep_inputs_t& sweep) {
  for (const input_span_t& input : sweep.inputs) {
    if (input.channel == channel::kImu.name && input.used_count > 0) return input.used_digest;
  }
  return 0;
}

/// The newest orientation at the time of the sweep, unless that is too old; nothing if there is none.
std::string missed_orientation(const RecordedLog& played, const sweep_inputs_t& sweep) {
  const auto& all = played.messages(channel::kImu.name);
  auto after = all.upper_bound(sweep.utime);
  if (after == all.begin()) return {};
  const auto& [utime, message] = *std::prev(after);
  const auto name = static_cast<std::int64_t>(digest(message));
  if (sweep.utime - utime > kMaxOrientationAge || imu_used(sweep) == name) return {};
  return fmt::format("IMU at {} digest {}: sweep {} did not use it", utime, hex(name), printable(sweep.sweep_name));
}

/// A recorded sweep that is made anew of the log's lines, and not played.
bool is_from_lines(const RecordedLog& played, const RecordedName& sweep) {
  return !played.messages(channel::kLaserLine.name).empty() &&
         played.messages(channel::kSweepMark.name).contains(sweep.version);
}

/// The sweep whose end is marked there was assembled.
bool is_assembled(const RecordedLog& session, Utime ended) {
  return std::ranges::any_of(session.sweep_inputs(), [&](const sweep_inputs_t& sweep) {
    return std::ranges::any_of(sweep.inputs, [&](const input_span_t& input) {
      return input.channel == channel::kSweepMark.name && input.last_utime == ended;
    });
  });
}

/// Messages that the played log holds of the time of an assembled sweep, and that it did not use, or others.
std::string missed_messages(const RecordedLog& played, const sweep_inputs_t& sweep) {
  for (const input_span_t& input : sweep.inputs) {
    const std::string other = input.used_count > 1 ? missing_input(played, input) : "";
    if (!other.empty()) return fmt::format("{}: sweep {} used others", other, printable(sweep.sweep_name));
  }
  return {};
}

bool is_answered(const RecordedLog& session, const goal_t& goal) {
  return std::ranges::any_of(session.objects_of(channel::kPath), [&](const auto& entry) {
    if (!entry.second.whole() || !entry.second.fault().empty()) return false;
    const auto path = decode<path_t>(entry.second.bytes().value());
    return !path.provisional && path.goal[0] == goal.goal_x_m && path.goal[1] == goal.goal_y_m;
  });
}

}  // namespace

std::vector<std::string> not_used(const RecordedLog& played, const RecordedLog& session) {
  std::vector<std::string> lines;
  for (const auto& [name, object] : played.objects_of(channel::kSweep)) {
    if (!object.whole() || !object.fault().empty() || is_from_lines(played, name)) continue;
    const auto same = [&](const sweep_inputs_t& one) { return one.sweep_digest == name.digest; };
    const auto used = std::ranges::find_if(session.sweep_inputs(), same);
    if (used == session.sweep_inputs().end()) {
      lines.push_back(fmt::format("SWEEP {} at {} digest {}: the mapper did not use it", printable(name.key),
                                  object.utime(), hex(name.digest)));
    } else if (const std::string missed = missed_orientation(played, *used); !missed.empty()) {
      lines.push_back(missed);
    }
  }
  const bool raw = !played.messages(channel::kLaserLine.name).empty();
  for (const auto& [utime, bytes] : played.messages(channel::kSweepMark.name)) {
    const auto mark = decode<sweep_mark_t>(bytes);
    if (!raw || mark.mark != sweep_mark_t::ENDED || is_assembled(session, utime)) continue;
    lines.push_back(fmt::format("SWEEP_MARK at {}: no sweep {} was made", utime, mark.sweep));
  }
  for (const sweep_inputs_t& sweep : session.sweep_inputs()) {
    if (const std::string missed = missed_messages(played, sweep); raw && !missed.empty()) lines.push_back(missed);
  }
  for (const auto& [utime, bytes] : played.messages(channel::kGoal.name)) {
    const auto goal = decode<goal_t>(bytes);
    if (is_answered(session, goal)) continue;
    lines.push_back(fmt::format("GOAL {},{} at {}: no PATH answers it", goal.goal_x_m, goal.goal_y_m, utime));
  }
  return lines;
}

}  // namespace scanway
