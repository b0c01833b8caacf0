/// scanway-mapper: the mapper as a process of its own on LCM's bus.

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include <optional>

#include "common/bus/channels.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/messages/codec.h"
#include "common/process/params_teller.h"
#include "common/process/process_bus.h"
#include "common/process/program.h"
#include "common/process/work_timer.h"
#include "modules/mapper/node/arrival_keeper.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/mapper/node/sweep_assembler.h"
#include "modules/mapper/saving/map_folder.h"
#include "modules/mapper/saving/map_products.h"

namespace scanway {
namespace {

/// The map of another session; nothing if none is to be continued.
std::optional<SweepStore> map_to_continue(const std::string& folder, const std::optional<SweepStore>& state) {
  if (folder.empty()) return std::nullopt;
  if (!state) return saved_map(folder);
  state->continue_from(folder);  // From then on it is part of the state.
  return std::nullopt;
}

/// Makes the map that the process had when it ended; only those who lack it get it again.
void restore(LiveBus& bus, MapperNode& node, const SweepStore& store) {
  const std::size_t sweeps = store.logs().size();
  if (sweeps > 0) spdlog::info("working on {} kept sweeps", sweeps);
  bus.report({}, fmt::format("working on {} kept sweeps", sweeps));
  bus.hold(true);
  node.restore(store);
  bus.hold(false);
}

void tell_health(LiveBus& bus, const MapperNode& node, const SweepAssembler& assembler) {
  auto counters = node.counters();
  counters.merge(assembler.counters());
  const std::string of_node = node.summary(), of_assembler = assembler.summary();
  const bool both = !of_node.empty() && !of_assembler.empty();
  bus.report(std::move(counters), of_assembler + (both ? "; " : "") + of_node);
}

/// Saves the map as a folder of that name in `maps`. Throws InputError.
void save_map(const std::string& maps, const std::string& name, const SweepStore* sweeps, const MapperNode& node,
              const Robot& robot) {
  if (maps.empty() || sweeps == nullptr) {
    throw InputError("this mapper keeps no maps: start it with --maps DIR and --state DIR");
  }
  if (name.empty() || name.front() == '.' || name.find('/') != std::string::npos) {
    throw InputError("a map's name is that of one folder: without a / and not beginning with a dot");
  }
  MapSave save(maps + "/" + name);
  save.sweeps().take_over(*sweeps);
  write_map_products(node, save.files());
  save.commit(robot);
  spdlog::info("map version {} is saved in {}", node.mapper().map().version(), printable(maps + "/" + name));
}

struct MapFolders {
  std::string resumed;  ///< --resume
  std::string maps;     ///< --maps
};

int run(const ProgramOptions& options, const MapFolders& folders) {
  const Robot robot = robot_of(options);
  const Identity who = this_process("mapper");
  LiveBusOptions live = live_bus_options(options);
  for (const Channel* said_once :
       {&channel::kSweepInputs, &channel::kRegistration, &channel::kPose, &channel::kMapAnswer}) {
    live.repeated.emplace_back(said_once->name);
  }
  std::optional<SweepStore> store;
  std::optional<ArrivalKeeper> keeper;
  if (!options.state.empty()) {
    keeper.emplace(store.emplace(options.state));
    live.tap = [&keeper](const BusMessage& message) { keeper->take(message); };
  }

  const std::optional<SweepStore> continued = map_to_continue(folders.resumed, store);

  ProcessBus process(options.lcm_url, who, live);
  LiveBus& bus = process.live();
  WorkTimer timer(bus);
  ParamsTeller params(bus, who.process, robot, who.start);
  MapperNode node(bus, robot, &timer);
  SweepAssembler assembler(bus, robot, [&node](SweepOrigin origin) { node.expect(std::move(origin)); });
  node.on_finished([&](std::string_view sweep, Utime utime) {
    timer.finish(sweep, utime);
    params.tell();
  });
  node.on_save([&](const std::string& name) { save_map(folders.maps, name, store ? &*store : nullptr, node, robot); });
  process.start();
  params.tell();
  if (continued) node.resume(*continued);
  if (store) restore(bus, node, *store);
  spdlog::info("ready: map version {}", node.mapper().map().version());
  serve(bus, {[&] { return node.news() + assembler.news(); },
              [&] {
                assembler.settle();
                if (!assembler.busy()) node.settle(bus.lacks(channel::kSweep.name));
              },
              [&] {
                map_state_t state = node.state();
                state.settled = state.settled && !assembler.busy();
                bus.publish(channel::kMapState.name, encode(state), state.utime);
                tell_health(bus, node, assembler);
              }});
  spdlog::info("ended at map version {}", node.mapper().map().version());
  return 0;
}

}  // namespace
}  // namespace scanway

int main(int argc, char** argv) {
  scanway::MapFolders folders;
  return scanway::run_program(
      "scanway-mapper", "Sweeps in; a registered map, a cost map and an OctoMap out", argc, argv,
      [&folders](const scanway::ProgramOptions& options) { return scanway::run(options, folders); },
      [&folders](CLI::App& app) {
        app.add_option("--resume", folders.resumed,
                       "Folder of kept sweeps (--state of another session): go on with their map");
        app.add_option("--maps", folders.maps, "Folder in which `scanway map keep` may save the map (with --state)");
      });
}
