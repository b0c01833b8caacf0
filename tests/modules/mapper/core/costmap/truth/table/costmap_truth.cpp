// The cost map of three sweeps at their true poses against the simulator's truth.
#include <cstdio>
#include <string>

#include "common/files/atomic_file.h"
#include "common/picture/canvas.h"
#include "tests/modules/mapper/core/costmap/truth/judged_map.h"

namespace scanway::testing {
namespace {

using simulator::CellTruth;

constexpr Colour kWhite = {255, 255, 255}, kBlack = {0, 0, 0}, kGrey = {150, 150, 150}, kPale = {215, 215, 215};
constexpr Colour kRed = {220, 30, 30}, kOrange = {245, 160, 40}, kMagenta = {230, 0, 230};
constexpr Colour kBlue = {40, 70, 220}, kCyan = {0, 190, 210}, kYellow = {240, 230, 60}, kYellowish = {250, 225, 170};

Colour colour_of(CellTruth truth, CellState state, int near, int visible) {
  if (near == 0) return state == CellState::free ? kYellow : state == CellState::occupied ? kGrey : kPale;
  switch (truth) {
    case CellTruth::free:
      if (state == CellState::free) return kWhite;
      if (state == CellState::occupied) return visible > 0 ? kRed : kGrey;
      return visible > 1 ? kOrange : visible == 1 ? kYellowish : kPale;
    case CellTruth::occupied:
      return state == CellState::free ? kMagenta : state == CellState::occupied ? kBlack : kGrey;
    case CellTruth::drop_off:
      return state == CellState::occupied ? kBlue : kCyan;
    default:
      return kPale;
  }
}

void draw(const JudgedMap& judged, const std::string& path) {
  const simulator::CellWindow& window = judged.seen.window;
  Raster raster(judged.truth.width, judged.truth.height, window.resolution_m, {0.0, 0.0}, kPale);
  for (std::int32_t y = window.low_y; y < window.high_y; ++y) {
    for (std::int32_t x = window.low_x; x < window.high_x; ++x) {
      const Eigen::Vector3d p = judged.X_map_world * Eigen::Vector3d(window.centre(x), window.centre(y), 0.0);
      const Cell cell{static_cast<std::int32_t>(std::floor(p.x() / judged.map.resolution_m)),
                      static_cast<std::int32_t>(std::floor(p.y() / judged.map.resolution_m))};
      const std::size_t i = window.index(x, y);
      raster.at(x - window.low_x, window.high_y - 1 - y) =
          colour_of(judged.truth.at({x, y}), judged.map.state(cell), judged.seen.near[i], judged.seen.visible[i]);
    }
  }
  Canvas canvas(raster);
  canvas.legend_field(kRed, "free called occupied");
  canvas.legend_field(kOrange, "free not known");
  canvas.legend_field(kMagenta, "occupied called free");
  canvas.legend_field(kCyan, "drop-off not occupied");
  canvas.legend_field(kYellow, "free, not seen");
  AtomicFile file(path);
  file.write(canvas.png());
  file.commit();
}

double percent(std::int64_t part, std::int64_t whole) { return whole == 0 ? 0.0 : 100.0 * part / whole; }

void print_row(const std::string& name, const tools::CellCounts& c) {
  std::printf("| %s | %lld | %.3f | %.3f | %lld | %lld | %.3f | %lld | %lld | %lld | %lld |\n", name.c_str(),
              static_cast<long long>(c.free), percent(c.free_called_occupied, c.free),
              percent(c.free_called_unknown, c.free), static_cast<long long>(c.occupied),
              static_cast<long long>(c.occupied_called_free), percent(c.occupied_called_free, c.occupied),
              static_cast<long long>(c.occupied_unmarked), static_cast<long long>(c.drop_offs),
              static_cast<long long>(c.drop_offs_unmarked), static_cast<long long>(c.drop_offs_open));
  std::fflush(stdout);
}

}  // namespace
}  // namespace scanway::testing

int main(int argc, char** argv) {
  using namespace scanway::testing;
  if (argc < 4) {
    std::puts(
        "costmap_truth WORLD SEED THIN [--paper] [FOLDER for a picture]; thin 1: full sweeps, n: every n-th line and "
        "beam; --paper: the map that the robot file's paper_projection makes");
    return 2;
  }
  scanway::Robot::Mapping mapping;
  mapping.paper_projection = argc > 4 && argv[4] == std::string("--paper");
  const int folder = mapping.paper_projection ? 5 : 4;
  SweepPlan plan;
  plan.thin = std::stoi(argv[3]);
  const std::string name = std::string(argv[1]) + " " + argv[2] + (mapping.paper_projection ? ", paper" : "");
  const JudgedMap judged = judge(take_sweeps(argv[1], std::stoull(argv[2]), plan), mapping);
  print_row(name + ", two", judged.counts.two);
  std::printf("| %s, two | lost where two sweeps saw the air above, too | %.3f |\n", name.c_str(),
              percent(judged.lost_in_clear_air, judged.counts.two.free));
  print_row(name + ", one", judged.counts.one);
  std::printf("| %s, none | %lld | called free %lld |\n", name.c_str(), static_cast<long long>(judged.counts.unseen),
              static_cast<long long>(judged.counts.unseen_called_free));
  if (argc > folder) draw(judged, std::string(argv[folder]) + "/" + argv[1] + "-" + argv[2] + ".png");
}
