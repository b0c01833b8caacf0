// Soft ground as the mapper tells it against what the simulated worlds are made of.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "tests/bench/ground/vegetation/logistic_fit.h"

namespace scanway::bench {
namespace {

constexpr double kSigma = 0.01;  // of the simulated range
constexpr double kEdge = 0.08;   // metres: rougher patches hold the foot of something, and are not fitted to
constexpr int kSweeps = 3;
// Windows get dirty, and no two lawns are as bright: what is fitted to must not hang on the last percent of it.
constexpr std::array kBrightness = {0.95, 1.0, 1.05};
const std::vector<std::string> kWorlds = {"yard", "car_park", "kerbs", "field", "street", "trench", "flat"};

struct Counts {
  int grass = 0, found = 0, grass_called_hard = 0;
  int other = 0, other_called_soft = 0, other_called_hard = 0;

  void add(const JudgedPatch& patch) {
    (patch.grass() ? grass : other) += 1;
    if (patch.called == Softness::soft) (patch.grass() ? found : other_called_soft) += 1;
    if (patch.called == Softness::hard) (patch.grass() ? grass_called_hard : other_called_hard) += 1;
  }
};

double percent(int part, int whole) { return whole == 0 ? 0.0 : 100.0 * part / whole; }

void print_row(const std::string& name, const Counts& c) {
  std::printf("| %s | %d | %.1f | %.1f | %d | %.2f | %.1f | %.1f |\n", name.c_str(), c.grass, percent(c.found, c.grass),
              percent(c.grass_called_hard, c.grass), c.other, percent(c.other_called_soft, c.other),
              percent(c.other_called_hard, c.other), percent(c.found, c.found + c.other_called_soft));
  std::fflush(stdout);
}

void print_head() {
  std::puts("| patches | grass | called soft, % | hard, % | other | called soft, % | hard, % | precision, % |");
  std::puts("|---|---|---|---|---|---|---|---|");
}

int judge(std::uint64_t seed, int thin, double brightness) {
  print_head();
  Counts all;
  std::map<int, Counts> by_range;
  for (const std::string& world : kWorlds) {
    Counts counts;
    for (const JudgedPatch& patch : patches_of_world(world, seed, kSweeps, thin, brightness)) {
      counts.add(patch), all.add(patch);
      by_range[static_cast<int>(patch.patch.range_m / 2.5)].add(patch);
    }
    print_row(world, counts);
  }
  for (const auto& [range, counts] : by_range) {
    print_row(std::to_string(range * 2.5).substr(0, 4) + " m and on", counts);
  }
  print_row("all", all);
  return 0;
}

int fit(std::uint64_t seeds, int thin) {
  std::vector<JudgedPatch> patches;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    for (const std::string& world : kWorlds) {
      for (const double brightness : kBrightness) {
        const auto of_world = patches_of_world(world, seed, kSweeps, thin, brightness);
        std::copy_if(of_world.begin(), of_world.end(), std::back_inserter(patches),
                     [](const JudgedPatch& judged) { return judged.patch.roughness_m < kEdge; });
      }
    }
  }
  const SoftGroundModel model = fit_model(patches, kSigma);
  std::printf("%zu patches; weights:", patches.size());
  for (const double weight : model.weights) std::printf(" %.3f,", weight);
  std::puts("");
  return 0;
}

}  // namespace
}  // namespace scanway::bench

int main(int argc, char** argv) {
  const std::string what = argc >= 4 ? argv[1] : "";
  if (what == "fit") return scanway::bench::fit(std::strtoull(argv[2], nullptr, 10), std::atoi(argv[3]));
  if (what == "judge") {
    const double brightness = argc > 4 ? std::atof(argv[4]) : 1.0;
    return scanway::bench::judge(std::strtoull(argv[2], nullptr, 10), std::atoi(argv[3]), brightness);
  }
  std::puts(
      "vegetation_bench fit SEEDS THIN: weights from the worlds of seeds 1 to SEEDS\n"
      "vegetation_bench judge SEED THIN [BRIGHTNESS]: soft ground against what the worlds of that seed are made of");
  return 2;
}
