#include "modules/tools/plan/plan_answer.h"

#include <cmath>

#include <fmt/format.h>

namespace scanway::tools {

using nlohmann::ordered_json;
using planning::Explanation;
using planning::PathPose;
using planning::PlanResult;
using planning::PlanStatus;

const char* name_of(UnknownPolicy policy) {
  if (policy == UnknownPolicy::price) return "price";
  return policy == UnknownPolicy::free ? "free" : "never";
}

ordered_json json_of(const PlanResult& result) {
  ordered_json json;
  json["status"] = result.reason;
  json["unknown"] = name_of(result.unknown);
  json["length_m"] = result.length_m;
  // JSON has no infinity: null says that there is no obstacle to be near to.
  const bool near = result.status == PlanStatus::ok && std::isfinite(result.clearance_m);
  json["clearance_m"] = std::isfinite(result.clearance_m) ? ordered_json(result.clearance_m) : nullptr;
  json["clearance_at_m"] =
      near ? ordered_json{result.clearance_at_m.x(), result.clearance_at_m.y()} : ordered_json(nullptr);
  json["unknown_share"] = result.unknown_share;
  json["cost"] = result.cost;
  json["worst_cost"] = result.worst_cost;
  json["duration_s"] = result.path.empty() ? 0.0 : result.path.back().time_s;
  json["path"] = json["time_s"] = json["speed_m_s"] = ordered_json::array();
  for (const PathPose& pose : result.path) {
    json["path"].push_back({pose.x_m, pose.y_m, pose.heading});
    json["time_s"].push_back(pose.time_s);
    json["speed_m_s"].push_back(pose.speed_m_s);
  }
  json["expansions"] = result.effort.expansions;
  return json;
}

ordered_json json_of(const Explanation& why) {
  ordered_json json = {{"text", why.text}};
  const auto place = [&](const char* key, const std::optional<Eigen::Vector2d>& at) {
    if (at) json[key] = {at->x(), at->y()};
  };
  const auto number = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = *value;
  };
  place("at_m", why.at_m);
  number("width_m", why.width_m);
  number("needed_m", why.needed_m);
  number("turning_m", why.turning_m);
  number("blocked_m", why.blocked_m);
  place("near_m", why.near_m);
  number("reached_m2", why.reached_m2);
  number("unknown_m", why.unknown_m);
  return json;
}

std::string text_of(const PlanResult& result) {
  if (result.status != PlanStatus::ok)
    return fmt::format("no path: {} (unknown {})", result.reason, name_of(result.unknown));
  const std::string clearance = std::isfinite(result.clearance_m)
                                    ? fmt::format("clearance {:.3f} m at ({:.2f}, {:.2f})", result.clearance_m,
                                                  result.clearance_at_m.x(), result.clearance_at_m.y())
                                    : "no obstacle anywhere";
  return fmt::format("length {:.3f} m, cost {:.3f}, {}, {:.1f} % unknown (unknown {}), {:.1f} s, {} expansions",
                     result.length_m, result.cost, clearance, 100.0 * result.unknown_share, name_of(result.unknown),
                     result.path.back().time_s, result.effort.expansions);
}

std::string csv_of(const PlanResult& result) {
  std::string csv = "x_m,y_m,heading_rad,time_s,speed_m_s\n";
  for (const PathPose& pose : result.path) {
    csv += fmt::format("{},{},{},{},{}\n", pose.x_m, pose.y_m, pose.heading, pose.time_s, pose.speed_m_s);
  }
  return csv;
}

}  // namespace scanway::tools
