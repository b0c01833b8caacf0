#include "common/grid/map_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "common/config/nearest_key.h"
#include "common/config/units.h"
#include "common/config/yaml_document.h"
#include "common/config/yaml_reader.h"
#include "common/files/atomic_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/read_file.h"
#include "common/grid/bounds.h"
#include "common/grid/pgm.h"

namespace scanway {
namespace {

constexpr char kOccupiedGrey = 0;
constexpr char kFreeGrey = static_cast<char>(254);
constexpr char kUnknownGrey = static_cast<char>(205);  // occupancy 50 / 255, just above the free threshold 0.196

/// What the YAML file says.
struct MapDescription {
  std::string image;
  double resolution_m = 0.0;
  std::array<double, 3> origin{};  ///< x, y in metres, yaw in radians.
  bool negate = false;
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;
};

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw InputError(printable(path) + ": " + what);
}

void require_keys(const YAML::Node& mapping, const std::string& path) {
  for (const char* key : {"image", "resolution", "origin"}) {
    if (!mapping[key]) fail(path, std::string("key ").append(key) + " is missing: is it the YAML file of a map?");
  }
}

/// A slip in a key must not go unseen: its value would be the default.
void refuse_slips(const YAML::Node& mapping, const std::string& path) {
  const std::vector<std::string> known = {"image", "resolution",      "origin",     "negate",
                                          "mode",  "occupied_thresh", "free_thresh"};
  for (const auto& entry : mapping) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const std::string meant = nearest_key(key, known);
    if (meant.empty() || std::ranges::find(known, key) != known.end()) continue;
    fail(path, "unknown key " + printable(key) + " (line " + std::to_string(line_of(entry.first)) + "): did you mean " +
                   meant + "?");
  }
}

bool truth_of(const YAML::Node& node, const std::string& path) {
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  if (text == "1" || text == "true") return true;
  if (text == "0" || text == "false") return false;
  fail(path, "negate (line " + std::to_string(line_of(node)) + ") must be 0 or 1, not " + in_quotes(text));
}

void check(const MapDescription& description, const std::string& path) {
  if (description.origin[2] != 0.0) fail(path, "origin has a yaw that is not 0: turn the picture, and write yaw 0");
  if (description.free_threshold >= description.occupied_threshold) {
    fail(path, "free_thresh must be smaller than occupied_thresh");
  }
}

MapDescription read_description(const std::string& path) {
  const YAML::Node mapping = yaml_mapping(read_file(path), path);
  refuse_slips(mapping, path);
  require_keys(mapping, path);
  YamlReader reader(mapping, path);
  MapDescription description;
  const std::array<std::string_view, 1> modes = {"trinary"};
  int mode = 0;
  reader.text("image", description.image);
  reader.number("resolution", description.resolution_m, {1e-4, 1000});
  reader.numbers("origin", description.origin, {-1e9, 1e9});
  reader.number("occupied_thresh", description.occupied_threshold, {0, 1});
  reader.number("free_thresh", description.free_threshold, {0, 1});
  reader.choice("mode", mode, modes);
  if (const YAML::Node negate = mapping["negate"]) description.negate = truth_of(negate, path);
  check(description, path);
  return description;
}

/// The state of every grey.
std::vector<CellState> states_of_greys(const MapDescription& description, int brightest) {
  std::vector<CellState> states(static_cast<std::size_t>(brightest) + 1, CellState::unknown);
  for (int grey = 0; grey <= brightest; ++grey) {
    const int darkness = description.negate ? grey : brightest - grey;
    const double occupancy = static_cast<double>(darkness) / brightest;
    CellState& state = states[static_cast<std::size_t>(grey)];
    if (occupancy <= description.free_threshold) state = CellState::free;
    if (occupancy >= description.occupied_threshold) state = CellState::occupied;
  }
  return states;
}

/// Fills the tile from the picture; false when the picture knows nothing there.
bool fill(CostTile& cells, Cell tile, const GreyPicture& picture, const std::vector<CellState>& states) {
  const std::int32_t left = tile.x * CostTile::kSide, low = tile.y * CostTile::kSide;
  const std::int32_t right = std::min(picture.width, left + CostTile::kSide);
  const std::int32_t high = std::min(picture.height, low + CostTile::kSide);
  bool any = false;
  for (std::int32_t y = low; y < high; ++y) {
    const auto row = static_cast<std::size_t>(picture.height - 1 - y) * static_cast<std::size_t>(picture.width);
    const auto out = cells.state.begin() + static_cast<std::ptrdiff_t>(y - low) * CostTile::kSide;
    for (std::int32_t x = left; x < right; ++x) {
      const CellState state = states[picture.grey[row + static_cast<std::size_t>(x)]];
      out[x - left] = state;
      any |= state != CellState::unknown;
    }
  }
  return any;
}

/// The known part of the map as greys, row by row from the top.
std::string greys_of(const CostMap& map, const CellRectangle& part) {
  const auto width = static_cast<std::size_t>(part.width());
  std::string greys(width * static_cast<std::size_t>(part.height()), kUnknownGrey);
  constexpr std::array kGreys = {kUnknownGrey, kFreeGrey, kOccupiedGrey};
  for (const auto& [tile, cells] : map.tiles) {
    const std::int32_t left = tile.x * CostTile::kSide, low = tile.y * CostTile::kSide;
    for (std::size_t i = 0; i < CostTile::kCells; ++i) {
      if (cells.state[i] == CellState::unknown) continue;  // and so within `part` otherwise
      const auto x = static_cast<std::size_t>(left + static_cast<std::int32_t>(i % CostTile::kSide) - part.low.x);
      const auto y = static_cast<std::size_t>(part.high.y - 1 - (low + static_cast<std::int32_t>(i / CostTile::kSide)));
      greys[y * width + x] = kGreys[static_cast<std::size_t>(cells.state[i])];
    }
  }
  return greys;
}

std::string yaml_of(const CostMap& map, Cell corner, const std::string& image) {
  const auto number = [](double value) { return text_from_si(value, std::nullopt); };
  const double x = map.origin_x_m + corner.x * map.resolution_m, y = map.origin_y_m + corner.y * map.resolution_m;
  return "image: " + image + "\nmode: trinary\nresolution: " + number(map.resolution_m) + "\norigin: [" + number(x) +
         ", " + number(y) + ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

}  // namespace

CostMap read_map(const std::string& path) { return read_pictured_map(path).map; }

PicturedMap read_pictured_map(const std::string& path) {
  const MapDescription description = read_description(path);
  // An absolute image path stays as it is.
  const std::string image = (std::filesystem::path(path).parent_path() / description.image).string();
  const GreyPicture picture = picture_from_pgm(read_file(image), image);
  const std::vector<CellState> states = states_of_greys(description, picture.brightest);
  CostMap map{description.resolution_m, description.origin[0], description.origin[1], {}};
  for (std::int32_t x = 0; x * CostTile::kSide < picture.width; ++x) {
    for (std::int32_t y = 0; y * CostTile::kSide < picture.height; ++y) {
      const auto tile = map.tiles.try_emplace(map.tiles.end(), Cell{x, y});
      if (!fill(tile->second, {x, y}, picture, states)) map.tiles.erase(tile);
    }
  }
  return {std::move(map), {{0, 0}, {picture.width, picture.height}}};
}

void write_map(const CostMap& map, const std::string& path) {
  const CellRectangle part = bounds(map).value_or(CellRectangle{{0, 0}, {1, 1}});
  const auto image = std::filesystem::path(path).replace_extension(".pgm");
  write_file(image.string(), pgm_from_bytes(static_cast<std::int32_t>(part.width()),
                                            static_cast<std::int32_t>(part.height()), greys_of(map, part)));
  write_file(path, yaml_of(map, part.low, image.filename().string()));
}

}  // namespace scanway
