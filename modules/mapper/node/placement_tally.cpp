#include "modules/mapper/node/placement_tally.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "common/files/printable.h"
#include "common/math/repeatable.h"

namespace scanway {
namespace {

void tell(const MapCorrection& correction) {
  spdlog::info("{} sweeps moved by up to {:.1f} cm and {:.2f} degrees: the map followed", correction.remade,
               100.0 * correction.shift_m, correction.turn * 180.0 / repeatable::kPi);
}

}  // namespace

void PlacementTally::count(const SweepResult& result) {
  const bool refused = result.verdict == Verdict::refused;
  refused_ += refused ? 1 : 0;
  moved_ += result.movement.robot.moved ? 1 : 0;
  scenes_moved_ += result.movement.scene.moved() ? 1 : 0;
  if (result.correction.remade > 0) {
    ++corrections_;
    tell(result.correction);
  }
  note_.clear();
  const std::string ground = refused ? "" : said_of(result.change.ground);
  without_ground_ += ground.empty() ? 0 : 1;
  const std::string said = said_of(result.movement) + ground;
  if (refused) {
    note_ = fmt::format("{} was refused: {}", printable(result.name), printable(result.reason));
  } else if (!said.empty()) {
    note_ = fmt::format("{}:{}", printable(result.name), said);
  }
}

std::map<std::string, std::int64_t> PlacementTally::counters() const {
  return {{"mapper_sweeps_refused", refused_},
          {"mapper_sweeps_moved", moved_},
          {"mapper_scenes_moved", scenes_moved_},
          {"mapper_sweeps_without_ground", without_ground_},
          {"mapper_corrections", corrections_}};
}

}  // namespace scanway
