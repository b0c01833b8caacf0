#include "tests/modules/planner/support/maps.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace scanway::test {
namespace {

std::string moving_ai_path(const std::string& file) {
  return std::string(SCANWAY_SHARED_DIR) + "/data/grid_maps_movingai/" + file;
}

std::int32_t below(std::int32_t n, Random& random) {
  return static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(n)));
}

void scatter(TestMap& map, CellState state, double share, Random& random) {
  const auto cells = static_cast<std::int64_t>(share * static_cast<double>(map.bounds.width() * map.bounds.height()));
  for (std::int64_t placed = 0; placed < cells;) {
    const Cell low = random_cell(map.bounds, random);
    const std::int32_t side = 1 + below(6, random);
    const Cell high = {low.x + (random.below(2) == 0 ? 1 : side), low.y + (random.below(2) == 0 ? 1 : side)};
    map.fill({low, {std::min(high.x, map.bounds.high.x), std::min(high.y, map.bounds.high.y)}}, state);
    placed += std::int64_t{high.x - low.x} * (high.y - low.y);
  }
}

}  // namespace

void TestMap::fill(CellRectangle cells, CellState state) {
  for (std::int32_t y = cells.low.y; y < cells.high.y; ++y) {
    for (std::int32_t x = cells.low.x; x < cells.high.x; ++x) map.set_state({x, y}, state);
  }
}

TestMap free_map(std::int32_t width, std::int32_t height, double resolution_m) {
  TestMap map{{resolution_m, 0.0, 0.0, {}}, {{0, 0}, {width, height}}};
  map.fill(map.bounds, CellState::free);
  return map;
}

TestMap random_map(std::int32_t width, std::int32_t height, double resolution_m, double share, bool unknown,
                   Random& random) {
  TestMap map = free_map(width, height, resolution_m);
  if (unknown) scatter(map, CellState::unknown, share, random);
  scatter(map, CellState::occupied, share, random);
  return map;
}

void add_random_costs(TestMap& map, Random& random) {
  for (int patch = 0; patch < 20; ++patch) {
    const Cell low = random_cell(map.bounds, random);
    const Cell high = random_cell({low, map.bounds.high}, random);
    const auto cost = static_cast<std::uint32_t>(random.below(2 * kCostOne));
    for (std::int32_t y = low.y; y <= high.y; ++y) {
      for (std::int32_t x = low.x; x <= high.x; ++x) map.map.set_cost({x, y}, cost);
    }
  }
}

Cell random_cell(const CellRectangle& bounds, Random& random) {
  return {bounds.low.x + below(static_cast<std::int32_t>(bounds.width()), random),
          bounds.low.y + below(static_cast<std::int32_t>(bounds.height()), random)};
}

bool has_moving_ai_maps() { return std::filesystem::exists(moving_ai_path("arena.map")); }

TestMap moving_ai_map(const std::string& name) {
  std::ifstream file(moving_ai_path(name + ".map"));
  std::string word;
  std::int32_t width = 0, height = 0;
  file >> word >> word >> word >> height >> word >> width >> word;
  if (word != "map") throw std::runtime_error("no map of Moving AI: " + name);
  TestMap map{{1.0, 0.0, 0.0, {}}, {{0, 0}, {width, height}}};
  for (std::int32_t y = 0; y < height; ++y) {
    file >> word;
    for (std::int32_t x = 0; x < width; ++x) {
      const char c = word.at(static_cast<std::size_t>(x));
      map.map.set_state({x, y}, c == '.' || c == 'G' ? CellState::free : CellState::occupied);
    }
  }
  return map;
}

std::vector<Problem> moving_ai_problems(const std::string& name) {
  std::ifstream file(moving_ai_path(name + ".map.scen"));
  std::string line;
  std::getline(file, line);
  std::vector<Problem> problems;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string bucket, map, width, height;
    Problem problem;
    if (fields >> bucket >> map >> width >> height >> problem.start.x >> problem.start.y >> problem.goal.x >>
        problem.goal.y >> problem.optimal_length) {
      problems.push_back(problem);
    }
  }
  return problems;
}

Eigen::Vector2d middle_of(const CostMap& map, Cell cell) {
  return {map.origin_x_m + (cell.x + 0.5) * map.resolution_m, map.origin_y_m + (cell.y + 0.5) * map.resolution_m};
}

}  // namespace scanway::test
