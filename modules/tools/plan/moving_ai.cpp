#include "modules/tools/plan/moving_ai.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/read_file.h"
#include "common/files/text_lines.h"

namespace scanway::tools {
namespace {

constexpr std::uint64_t kLongestSide = 20'000;

class Reader {
 public:
  Reader(const std::string& path) : path_(path), text_(read_file(path)), lines_(text_) {}

  std::optional<std::string_view> next() { return lines_.next(); }
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("{}: line {}: {}", printable(path_), lines_.number(), what));
  }
  std::string_view expect_line(const char* what) {
    const auto line = next();
    if (!line) refuse(fmt::format("the file ends where {} should follow", what));
    return *line;
  }
  std::int32_t count(std::string_view& line, const char* what, std::uint64_t end) const {
    const std::string_view token = take_token(line);
    const auto count = parse_count(token);
    if (!count || *count >= end)
      refuse(fmt::format("{} is {}; must be a whole number below {}", what, in_quotes(token), end));
    return static_cast<std::int32_t>(*count);
  }

 private:
  std::string path_;
  std::string text_;
  TextLines lines_;
};

std::int32_t read_side(Reader& reader, const char* name) {
  std::string_view line = reader.expect_line(name);
  if (take_token(line) != name) reader.refuse(fmt::format("must be \"{} N\"", name));
  return reader.count(line, name, kLongestSide);
}

bool is_passable(char c) { return c == '.' || c == 'G' || c == 'S'; }

void read_octile_map(const std::string& path, Scenario& scenario) {
  Reader reader(path);
  if (reader.expect_line("\"type octile\"") != "type octile") reader.refuse("must be \"type octile\"");
  const std::int32_t height = read_side(reader, "height");
  const std::int32_t width = read_side(reader, "width");
  if (reader.expect_line("\"map\"") != "map") reader.refuse("must be \"map\"");
  scenario.map.resolution_m = 1.0;
  scenario.bounds = {{0, 0}, {width, height}};
  for (std::int32_t y = 0; y < height; ++y) {
    const std::string_view row = reader.expect_line("a row of the map");
    if (row.size() != static_cast<std::size_t>(width)) {
      reader.refuse(fmt::format("the row has {} cells, the map is {} wide", row.size(), width));
    }
    for (std::int32_t x = 0; x < width; ++x) {
      const bool passable = is_passable(row[static_cast<std::size_t>(x)]);
      scenario.map.set_state({x, y}, passable ? CellState::free : CellState::occupied);
    }
  }
}

std::string map_beside(const std::string& path, std::string_view name) {
  return (std::filesystem::path(path).parent_path() / std::filesystem::path(std::string(name)).filename()).string();
}

ScenarioProblem read_problem(Reader& reader, std::string_view line, const CellRectangle& bounds) {
  const auto side_x = static_cast<std::uint64_t>(bounds.width()), side_y = static_cast<std::uint64_t>(bounds.height());
  const auto width = reader.count(line, "the width", kLongestSide);
  const auto height = reader.count(line, "the height", kLongestSide);
  if (width != bounds.width() || height != bounds.height()) {
    reader.refuse(fmt::format("is for a map of {} x {}, but the map is {} x {}; scaled scenarios are not supported",
                              width, height, bounds.width(), bounds.height()));
  }
  ScenarioProblem problem;
  problem.start.x = reader.count(line, "the start's x", side_x);
  problem.start.y = reader.count(line, "the start's y", side_y);
  problem.goal.x = reader.count(line, "the goal's x", side_x);
  problem.goal.y = reader.count(line, "the goal's y", side_y);
  const std::string_view token = take_token(line);
  const auto length = parse_number(token);
  if (!length || !(*length >= 0.0) || !std::isfinite(*length)) {
    reader.refuse(fmt::format("the optimal length is {}; must be a number", in_quotes(token)));
  }
  problem.optimal_length = *length;
  return problem;
}

}  // namespace

Scenario read_scenario(const std::string& path) {
  Reader reader(path);
  std::string_view version = reader.expect_line("\"version 1\"");
  if (take_token(version) != "version") reader.refuse("no scenario file of Moving AI: must be \"version 1\"");
  Scenario scenario;
  std::string map_name;
  while (auto line = reader.next()) {
    if (is_blank(*line)) continue;
    reader.count(*line, "the bucket", std::numeric_limits<std::int32_t>::max());
    const std::string_view name = take_token(*line);
    if (map_name.empty()) {
      map_name = name;
      read_octile_map(map_beside(path, name), scenario);
    }
    if (name != map_name)
      reader.refuse(fmt::format("names another map than the lines before it ({})", in_quotes(name)));
    scenario.problems.push_back(read_problem(reader, *line, scenario.bounds));
  }
  if (scenario.problems.empty()) reader.refuse("the file holds no problem");
  return scenario;
}

}  // namespace scanway::tools
