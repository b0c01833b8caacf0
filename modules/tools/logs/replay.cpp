#include "modules/tools/logs/replay.h"

#include <cstdio>
#include <utility>

#include <spdlog/spdlog.h>

#include "common/bus/log_reader.h"
#include "common/bus/log_writer.h"
#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/product_folder.h"
#include "modules/replay/products.h"
#include "modules/replay/replay.h"
#include "modules/replay/verify/verify.h"
#include "modules/tools/output/progress_bar.h"

namespace scanway::tools {
namespace {

constexpr int kLogWasDamaged = 1;

std::optional<SweepStore> map_of(const std::string& folder) {
  return folder.empty() ? std::nullopt : std::optional(saved_map(folder));
}

/// Where the map's sweeps are kept, with those of the map that it continues.
std::optional<SweepStore> new_store(const ReplayOptions& options) {
  if (options.kept.empty()) return std::nullopt;
  SweepStore store(options.kept);
  if (!store.logs().empty() || store.earlier()) {
    throw InputError(printable(options.kept) + ": keeps a map already; name a new folder with --keep");
  }
  if (!options.resumed.empty()) store.continue_from(options.resumed);
  return store;
}

}  // namespace

int run_replay(const ReplayOptions& options) {
  LogReader log(options.log);
  LogStory story = story_of_log(options.log);
  const std::optional<Robot> robot = options.robot.empty() ? story.robot : load_robot(options.robot);
  const ProductFolder folder(options.output);

  const std::optional<SweepStore> continued = map_of(options.resumed);
  const std::optional<SweepStore> kept = new_store(options);

  LogWriter recording(folder.path_of("out.lcmlog"));
  Replay replay(robot.value_or(Robot{}), recording, std::move(story));
  if (continued) replay.resume(*continued);
  if (kept) replay.keep_in(*kept);
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
        options.log, robot, [&bar](double share) { bar.show(share); }, options.played, options.resumed);
  }
  std::fputs(verification.remarks().c_str(), stderr);
  std::fputs(verification.findings().c_str(), stdout);
  return verification.status();
}

}  // namespace scanway::tools
