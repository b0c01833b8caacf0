#include "modules/tools/drive/drive.h"

#include <fmt/format.h>

#include <cstdio>

#include "common/files/printable.h"
#include "modules/tools/drive/driver.h"

namespace scanway::tools {
namespace {

constexpr int kNotThere = 1;

void say(const std::string& line) {
  std::puts(printable(line).c_str());
  std::fflush(stdout);
}

}  // namespace

int run_drive(const DriveOptions& options) {
  const Eigen::Vector2d goal(options.goal_m.first, options.goal_m.second);
  Driver driver(options.lcm_url);
  const path_t path = driver.ask_for_path(goal);
  if (path.status != "ok" || path.pose_x_m.empty()) {
    say(fmt::format("no way to {:.2f},{:.2f}: {}", goal.x(), goal.y(), path.status));
    return kNotThere;
  }
  say(fmt::format("a path of {:.2f} m, {:.2f} m clear, on map version {}", path.length_m, path.clearance_m,
                  path.map_version));
  const std::string trouble = driver.follow(path, options.speed_m_s);
  const Eigen::Vector2d at = driver.place();
  const std::string where = fmt::format("at {:.2f},{:.2f}, {:.2f} m from the goal", at.x(), at.y(), (at - goal).norm());
  say(trouble.empty() ? "arrived: " + where : "given up: " + trouble + "; " + where);
  return trouble.empty() ? 0 : kNotThere;
}

}  // namespace scanway::tools
