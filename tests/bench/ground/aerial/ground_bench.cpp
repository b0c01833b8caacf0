// Total errors of ground filters on the ISPRS samples: the mapper's ground, PCL's filter, and what is published.
#include <cstdio>
#include <exception>
#include <functional>
#include <string>

#include "tests/bench/ground/aerial/morphological_filter.h"
#include "tests/bench/ground/aerial/published.h"
#include "tests/bench/ground/aerial/stands_filter.h"

namespace scanway::bench {
namespace {

void print_sample(const Sample& sample) {
  std::printf(
      "\n%s: %zu points, %.2f m apart\n\n| filter | type I, %% | type II, %% | total, %% |\n|---|---|---|---|\n",
      sample.name.c_str(), sample.points.size(), sample.spacing_m());
  const auto print = [&](const char* filter, const std::vector<bool>& called_ground) {
    const Errors errors = errors_of(sample, called_ground);
    std::printf("| %s | %.2f | %.2f | %.2f |\n", filter, errors.type_1, errors.type_2, errors.total);
    std::fflush(stdout);
  };
  print("Scanway", stands_filter(sample, {}));
  print("PCL, progressive morphological", morphological_filter(sample));
  print("all ground", std::vector<bool>(sample.points.size(), true));
  for (const Published& published : kPublished) {
    std::printf("| %s (%s) | | | %.2f |\n", published.filter, published.source,
                sample.name == "samp11" ? published.samp11 : published.samp53);
  }
}

}  // namespace
}  // namespace scanway::bench

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::puts("ground_bench FOLDER, which holds samp11-utm.pcd and so on: ../shared/data/ground_reference_isprs");
    return 2;
  }
  for (const char* name : {"samp11", "samp53"}) {
    scanway::bench::print_sample(scanway::bench::read_sample(argv[1], name));
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "ground_bench: %s\n", error.what());
  return 2;
}
