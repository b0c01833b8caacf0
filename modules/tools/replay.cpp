#include "modules/tools/replay.h"

#include <cstdio>
#include <utility>

#include <spdlog/spdlog.h>

#include "common/bus/log_reader.h"
#include "common/bus/log_writer.h"
#include "common/config/robot_file.h"
#include "common/files/printable.h"
#include "common/files/product_folder.h"
#include "modules/replay/products.h"
#include "modules/replay/replay.h"
#include "modules/replay/verify/verify.h"
#include "modules/tools/progress_bar.h"

namespace scanway::tools {
namespace {

constexpr int kLogWasDamaged = 1;

}  // namespace

int run_replay(const ReplayOptions& options) {
  LogReader log(options.log);
  LogStory story = story_of_log(options.log);
  const std::optional<Robot> robot = options.robot.empty() ? story.robot : load_robot(options.robot);
  const ProductFolder folder(options.output);

  LogWriter recording(folder.path_of("out.lcmlog"));
  Replay replay(robot.value_or(Robot{}), recording, std::move(story));
  {
    ProgressBar bar("replaying " + printable(options.log));
    replay.run(log, [&bar](double share) { bar.show(share); });
  }
  recording.close();

  ReplayReport report = replay.report();
  report.log = options.log;
  report.trouble = log.trouble();
  report.digests = write_products(replay.mapper(), replay.planner(), folder);
  folder.write("report.json", report_json(report));
  std::fputs(report_table(report).c_str(), stdout);
  if (!report.trouble.empty()) {
    spdlog::error("{}: {}", printable(options.log), printable(report.trouble));
    return kLogWasDamaged;
  }
  if (!robot) spdlog::warn("{}: holds no configuration (PARAMS); took the built-in ERA-Mobi", printable(options.log));
  return 0;
}

int run_verify(const ReplayOptions& options) {
  std::optional<Robot> robot;
  if (!options.robot.empty()) robot = load_robot(options.robot);
  Verification verification;
  {
    ProgressBar bar("verifying " + printable(options.log));
    verification = verify(
        options.log, robot, [&bar](double share) { bar.show(share); }, options.played);
  }
  std::fputs(verification.remarks().c_str(), stderr);
  std::fputs(verification.findings().c_str(), stdout);
  return verification.status();
}

}  // namespace scanway::tools
