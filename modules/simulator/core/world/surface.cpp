#include "modules/simulator/core/world/surface.h"

#include <array>

namespace scanway::simulator {

std::string_view name_of(Label label) {
  static constexpr std::array<std::string_view, 14> kNames = {"nothing", "ground",    "building", "roof",    "pillar",
                                                              "fence",   "pole",      "tree",     "foliage", "car",
                                                              "debris",  "furniture", "robot",    "person"};
  return kNames.at(static_cast<std::size_t>(label));
}

const Optics& optics_of(Material material) {
  // In the order of Material. Reflectivities as data sheets of scanners for 905 nm print them, rounded.
  static constexpr std::array<Optics, 15> kOptics = {{
      {0.20, 0.8, 0.0, false},    // asphalt
      {0.40, 0.7, 0.0, false},    // concrete
      {0.35, 0.7, 0.0, false},    // paving
      {0.45, 0.9, 0.012, false},  // grass
      {0.30, 0.9, 0.006, false},  // soil
      {0.40, 0.5, 0.0, false},    // brick
      {0.70, 0.4, 0.0, false},    // plaster
      {0.45, 0.4, 0.0, false},    // wood
      {0.35, 0.1, 0.0, false},    // steel
      {0.65, 0.1, 0.0, false},    // bright_paint
      {0.06, 0.1, 0.0, false},    // dark_paint
      {0.10, 0.0, 0.0, true},     // glass
      {0.05, 0.5, 0.0, false},    // rubber
      {0.50, 0.9, 0.0, false},    // leaf
      {8.00, 1.0, 0.0, false},    // reflector
  }};
  return kOptics.at(static_cast<std::size_t>(material));
}

}  // namespace scanway::simulator
