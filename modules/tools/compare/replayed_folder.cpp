#include "modules/tools/compare/replayed_folder.h"

#include <map>

#include <nlohmann/json.hpp>

#include "common/bus/channels.h"
#include "common/bus/log_reader.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/read_file.h"
#include "common/grid/map_file.h"
#include "common/messages/object_assembler.h"
#include "common/messages/sweep_message.h"
#include "modules/replay/replay.h"

namespace scanway::tools {
namespace {

using Json = nlohmann::json;

Pose pose_of_rows(const Json& rows) {
  Pose X = Pose::Identity();
  for (int i = 0; i < 12; ++i) X.matrix()(i / 4, i % 4) = rows.at(static_cast<std::size_t>(i)).get<double>();
  return X;
}

std::vector<PlacedSweep> read_report(const std::string& path) {
  try {
    std::vector<PlacedSweep> sweeps;
    const Json report = Json::parse(read_file(path));
    for (const Json& scan : report.at("scans")) {
      PlacedSweep sweep;
      sweep.name = scan.at("name").get<std::string>();
      sweep.accepted = scan.at("verdict") == "accepted";
      sweep.probability = scan.at("probability").get<double>();
      sweep.T_map_scan = pose_of_rows(scan.at("T_map_scan"));
      if (!scan.contains("T_ref_scan")) {
        throw InputError(printable(path) + ": " + printable(sweep.name) +
                         " has no true pose; was the log recorded beside scanway-simulator?");
      }
      sweep.T_ref_scan = pose_of_rows(scan.at("T_ref_scan"));
      sweeps.push_back(std::move(sweep));
    }
    return sweeps;
  } catch (const Json::exception& error) {
    throw InputError(printable(path) + ": no report of scanway replay: " + printable(error.what()));
  }
}

std::map<std::string, Sweep> read_sweeps(const std::string& path) {
  std::map<std::string, Sweep> sweeps;
  ObjectAssembler assembler;
  LogReader log(path);
  while (const auto event = log.next()) {
    if (event->channel != channel::kSweep.name) continue;
    try {
      if (const auto object = assembler.add(decode<piece_t>(event->bytes))) {
        Sweep sweep = decode<Sweep>(object->bytes);
        sweeps[sweep.name] = std::move(sweep);
      }
    } catch (const BadMessage&) {
      // What replay could not use is in no map.
    }
  }
  return sweeps;
}

}  // namespace

ReplayedFolder read_replayed(const std::string& folder) {
  ReplayedFolder replayed;
  replayed.sweeps = read_report(folder + "/report.json");
  replayed.cost_map = read_map(folder + "/costmap.yaml");
  const std::string log = folder + "/out.lcmlog";
  replayed.robot = story_of_log(log).robot.value_or(Robot{});
  std::map<std::string, Sweep> sweeps = read_sweeps(log);
  for (PlacedSweep& placed : replayed.sweeps) {
    const auto sweep = sweeps.find(placed.name);
    if (sweep == sweeps.end()) throw InputError(printable(log) + ": lacks " + printable(placed.name));
    placed.sweep = std::move(sweep->second);
  }
  return replayed;
}

}  // namespace scanway::tools
