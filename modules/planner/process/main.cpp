/// scanway-planner: the planner as a process of its own on LCM's bus.

#include <spdlog/spdlog.h>

#include <filesystem>
#include <string>

#include "common/bus/channels.h"
#include "common/bus/log_reader.h"
#include "common/bus/log_writer.h"
#include "common/files/input_error.h"
#include "common/files/product_folder.h"
#include "common/process/params_teller.h"
#include "common/process/process_bus.h"
#include "common/process/program.h"
#include "common/process/work_timer.h"
#include "modules/planner/node/planner_node.h"

namespace scanway {
namespace {

constexpr Utime kClockUnused = 0;

/// Keeps the operator's goal over a restart, as a log with that one message.
class GoalFile {
 public:
  explicit GoalFile(const std::string& folder) {
    if (!folder.empty()) path_ = ProductFolder(folder).path_of("goal.lcmlog");
  }

  void keep(const BusMessage& goal) const {
    if (path_.empty()) return;
    try {
      LogWriter log(path_);
      log.write(goal.channel, goal.bytes, kClockUnused);
      log.close();
    } catch (const InputError& error) {
      spdlog::warn("the goal is not kept: {}", error.what());
    }
  }

  void tell(const Bus::Handler& handler) const {
    if (path_.empty() || !std::filesystem::exists(path_)) return;
    try {
      LogReader log(path_);
      if (const auto goal = log.next()) handler({channel::kGoal.name, goal->bytes, kClockUnused});
    } catch (const InputError& error) {
      spdlog::warn("the kept goal is lost: {}", error.what());
    }
  }

 private:
  std::string path_;
};

int run(const ProgramOptions& options) {
  const Robot robot = robot_of(options);
  const GoalFile kept_goal(options.state);

  const Identity who = this_process("planner");
  ProcessBus process(options.lcm_url, who, live_bus_options(options));
  LiveBus& bus = process.live();
  WorkTimer timer(bus);
  ParamsTeller params(bus, who.process, robot, who.start);
  PlannerNode node(bus, robot, &timer, PlannerNode::Pace::live);
  node.on_finished([&](std::string_view plan, Utime utime) {
    timer.finish(plan, utime);
    params.tell();
  });
  bus.subscribe(channel::kGoal.name, [&](const BusMessage& goal) { kept_goal.keep(goal); });
  process.start();
  params.tell();
  kept_goal.tell([&node](const BusMessage& goal) { node.take_goal(goal); });
  spdlog::info("ready");
  serve(bus, {[&node] { return node.news(); }, [&node] { node.settle(); },
              [&bus, &node] {
                bus.report(node.counters(), node.summary());
                if (node.outdated()) throw StartAgain("the mapper has begun another map");
              }});
  spdlog::info("ended");
  return 0;
}

}  // namespace
}  // namespace scanway

int main(int argc, char** argv) {
  return scanway::run_program("scanway-planner", "A cost map and a goal in; paths out", argc, argv, scanway::run);
}
