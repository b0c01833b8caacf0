#include "modules/tools/clouds/octomap_clouds.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "common/cloud/poses_file.h"
#include "common/cloud/read_cloud.h"
#include "common/files/atomic_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/messages/digest.h"
#include "common/progress/stage_timer.h"
#include "modules/mapper/core/octomap/occupancy_tree.h"

namespace scanway::tools {
namespace {

constexpr double kFinestM = 0.001;
constexpr double kCoarsestM = 100.0;

void check(const OctomapOptions& options) {
  if (options.clouds.empty()) throw InputError("octomap: no cloud file is named; name at least one");
  if (!(options.resolution_m >= kFinestM && options.resolution_m <= kCoarsestM)) {
    throw InputError(fmt::format("octomap: --resolution {} must be from {} to {} metres", options.resolution_m,
                                 kFinestM, kCoarsestM));
  }
  if (!std::isfinite(options.max_range_m) || options.max_range_m < 0.0) {
    throw InputError(
        fmt::format("octomap: --max-range {} must be a number of metres above 0; leave it out for beams of any length",
                    options.max_range_m));
  }
  if (!options.output.ends_with(".ot") && !options.output.ends_with(".bt")) {
    throw InputError(printable(options.output) +
                     ": its name says no kind of map; end it with .ot (log-odds) or .bt (free or occupied)");
  }
}

MapPoints read_sweep(const std::string& file, const Pose& X_map_scan) {
  CloudNotes notes;
  MapPoints sweep;
  sweep.points = read_cloud(file, &notes).points;
  if (!notes.sentence().empty()) spdlog::info("{}: {}", printable(file), notes.sentence());
  sweep.origin = X_map_scan.translation();
  for (Eigen::Vector3f& p : sweep.points) p = transform_in_order(X_map_scan, p.cast<double>()).cast<float>();
  return sweep;
}

void print(const OccupancyTree& tree, const std::string& bytes, StageTimer& timer, bool as_json) {
  const std::string digest_hex = hex(digest({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
  nlohmann::ordered_json json;
  const OccupancyTree::Size size = tree.size();
  json["nodes"] = size.nodes;
  json["leaves"] = size.leaves;
  json["bytes"] = bytes.size();
  json["digest"] = digest_hex;
  std::string seconds;
  for (const auto& [stage, s] : timer.finish()) {
    json["seconds"][stage] = s;
    seconds += fmt::format(" {} {:.3f},", stage, s);
  }
  json["seconds"]["total"] = timer.total_s();
  if (as_json) return (void)std::puts(json.dump(2).c_str());
  fmt::print("{} nodes, {} leaves, {} bytes, digest {}\nseconds:{} total {:.3f}\n", size.nodes, size.leaves,
             bytes.size(), digest_hex, seconds, timer.total_s());
}

}  // namespace

int run_octomap(const OctomapOptions& options) {
  check(options);
  const PosesFile poses = PosesFile::read(options.poses);
  for (const std::string& file : options.clouds) poses.pose_of(scan_name(file));  // Said before the long work.
  StageTimer timer;
  OccupancyTree tree({options.resolution_m, options.max_range_m, options.discretize});
  for (const std::string& file : options.clouds) {
    timer.begin("read");
    const MapPoints sweep = read_sweep(file, poses.pose_of(scan_name(file)));
    timer.begin("insert");
    tree.insert(sweep);
  }
  timer.begin("write");
  const std::string bytes = options.output.ends_with(".ot") ? tree.ot_bytes() : tree.bt_bytes();
  write_file(options.output, bytes);
  timer.finish();
  print(tree, bytes, timer, options.json);
  return 0;
}

}  // namespace scanway::tools
