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
#include "modules/mapper/saving/map_folder.h"
#include "modules/replay/products.h"
#include "modules/replay/replay.h"
#include "modules/replay/verify/verify.h"
#include "modules/tools/output/progress_bar.h"

namespace scanway::tools {
namespace {

constexpr int kLogWasDamaged = 1;

void require_new(const std::string& folder) {
  const SweepStore store(folder);
  if (!store.logs().empty() || store.earlier()) {
    throw InputError(printable(folder) + ": keeps a map already; name a new folder with --keep");
  }
}

/// The robot of --robot, else that of the map that the log goes on with, else the log's.
std::optional<Robot> robot_for(const ReplayOptions& options, const LogStory& story) {
  if (!options.robot.empty()) return load_robot(options.robot);
  const auto of_map = options.continued.empty() ? std::nullopt : robot_of_map(options.continued);
  return of_map ? of_map : story.robot;
}

/// The map that the log continues is part of the new one.
void take_earlier_map(const ReplayOptions& options, const MapSave& save, Replay& replay) {
  if (!options.resumed.empty()) {
    save.sweeps().continue_from(options.resumed);
    replay.resume(saved_map(options.resumed));
  }
  if (options.continued.empty()) return replay.keep_in(save.sweeps());
  save.sweeps().take_over(saved_map(options.continued));
  replay.go_on_with(save.sweeps());
}

}  // namespace

int run_replay(const ReplayOptions& options) {
  LogReader log(options.log);
  LogStory story = story_of_log(options.log);
  const std::optional<Robot> robot = robot_for(options, story);
  const ProductFolder folder(options.output);
  if (!options.kept.empty()) require_new(options.kept);
  MapSave save(options.output);

  LogWriter recording(folder.path_of("out.lcmlog"));
  Replay replay(robot.value_or(Robot{}), recording, std::move(story));
  take_earlier_map(options, save, replay);
  {
    ProgressBar bar("replaying " + printable(options.log));
    replay.run(log, [&bar](double share) { bar.show(share); });
  }
  recording.close();

  ReplayReport report = replay.report();
  report.log = options.log;
  report.trouble = log.trouble();
  report.digests = write_products(replay.mapper(), replay.planner(), save.files());
  if (!options.kept.empty()) SweepStore(options.kept).take_over(save.sweeps());
  save.commit(robot.value_or(Robot{}));
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
