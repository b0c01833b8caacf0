#include "modules/replay/verify/recorded_paths.h"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "common/files/printable.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "common/messages/goal_message.h"
#include "modules/replay/verify/derived_products.h"

namespace scanway {
namespace {

std::vector<Goal> goals_at(const RecordedLog& log, const Eigen::Vector2d& place) {
  std::vector<Goal> goals;
  for (const auto& [utime, bytes] : log.messages(channel::kGoal.name)) {
    const auto goal = decode<goal_t>(bytes);
    if (goal.goal_x_m == place.x() && goal.goal_y_m == place.y()) goals.push_back({goal.utime, place});
  }
  return goals;
}

std::optional<planning::BodyMode> mode_of(const std::string& name) {
  for (const auto mode : {planning::BodyMode::point, planning::BodyMode::paper, planning::BodyMode::footprint}) {
    if (name == name_of(mode)) return mode;
  }
  return std::nullopt;
}

bool starts_there(const path_t& path, const Start& pose) {
  const auto& place = pose.X_map_base.translation();
  return path.start[0] == place.x() && path.start[1] == place.y() &&
         path.start[2] == heading_of(pose.X_map_base.linear());
}

}  // namespace

RecordedPaths::RecordedPaths(const RecordedLog& log) {
  std::set<std::pair<double, double>> missing;
  for (const auto& [name, object] : log.objects_of(channel::kPath)) {
    if (name.key.starts_with("provisional")) continue;
    if (!object.fault().empty()) {
      if (!fault_.empty()) continue;
      fault_ = fmt::format("{}: {}; digest {} in the log", text_of(name), object.fault(),
                           hex(static_cast<std::uint64_t>(name.digest)));
      continue;
    }
    if (!object.whole()) {
      notes_.push_back("not compared: " + text_of(name) + ": lacks " + object.lacking());
      continue;
    }
    Recorded recorded{name, decode<path_t>(object.bytes().value()), {}, 0, false};
    const path_t& path = recorded.path;
    if (path.provisional) continue;
    recorded.goals = goals_at(log, {path.goal[0], path.goal[1]});
    if (recorded.goals.empty() && missing.emplace(path.goal[0], path.goal[1]).second) {
      missing_.push_back(fmt::format("GOAL {},{} at {} or before: {} leads there", path.goal[0], path.goal[1],
                                     path.utime, text_of(name)));
    }
    paths_.push_back(std::move(recorded));
  }
  note_versions();
}

// A plan's version is its time, or the one after that of the plan before (PathVersions).
void RecordedPaths::note_versions() {
  for (const Recorded& one : paths_) {
    const auto is_before = [&](const Recorded& other) {
      return other.name.key == one.name.key && other.name.version + 1 == one.name.version;
    };
    if (one.name.version == one.path.utime || std::ranges::any_of(paths_, is_before)) continue;
    notes_.push_back(text_of(one.name) + ": the log lacks the plan before, whose version it follows");
  }
}

std::string RecordedPaths::compare(const Robot& robot, const CostMap& map, const ClosedVersion& version) {
  for (Recorded& recorded : paths_) {
    if (recorded.path.map_version != version.version || recorded.path.map_digest != version.digest) continue;
    recorded.compared = true;
    recorded.version_utime = version.utime;
    ++compared_;
    const std::string difference = this->difference(recorded, robot, map, version);
    if (!difference.empty()) return text_of(recorded.name) + ": " + difference;
  }
  return {};
}

std::string RecordedPaths::difference(const Recorded& recorded, const Robot& robot, const CostMap& map,
                                      const ClosedVersion& version) const {
  const path_t& path = recorded.path;
  const auto mode = mode_of(path.mode);
  if (!mode || recorded.name.key != path.mode) return "no planner plans in mode " + in_quotes(path.mode);
  PlanBasis basis;
  basis.version = version;
  basis.start.emplace();
  basis.start->X_map_base = Pose::Identity();
  basis.start->X_map_base.translation().head<2>() = Eigen::Vector2d(path.start[0], path.start[1]);
  basis.goal = Goal{path.utime, {path.goal[0], path.goal[1]}};
  path_t derived = planned_path(robot, *mode, map, basis);
  // What is not known from the version alone: compare_starts() sees to it.
  derived.utime = path.utime;
  derived.start[2] = path.start[2];
  // How much work a search was is no part of its answer: a planner that searches otherwise gives the same path.
  derived.expansions = path.expansions;
  const auto digest_derived = static_cast<std::int64_t>(digest(encode(derived)));
  return digest_derived == recorded.name.digest ? std::string() : both_digests(recorded.name.digest, digest_derived);
}

std::string RecordedPaths::compare_starts(const std::vector<Start>& poses) const {
  if (!fault_.empty()) return fault_;
  for (const Recorded& recorded : paths_) {
    const path_t& path = recorded.path;
    if (!recorded.compared) {
      return fmt::format("{}: rests on map version {} with digest {}, which is not derived from the log",
                         text_of(recorded.name), path.map_version, hex(static_cast<std::uint64_t>(path.map_digest)));
    }
    if (recorded.goals.empty()) continue;
    const bool fits = std::ranges::any_of(poses, [&](const Start& pose) {
      return starts_there(path, pose) && std::ranges::any_of(recorded.goals, [&](const Goal& goal) {
               return path.utime == std::max({recorded.version_utime, pose.utime, goal.utime});
             });
    });
    if (!fits) {
      return fmt::format(
          "{}: starts at {},{} heading {} at {}, where the robot was not by what is derived from the log",
          text_of(recorded.name), path.start[0], path.start[1], path.start[2], path.utime);
    }
  }
  return {};
}

}  // namespace scanway
