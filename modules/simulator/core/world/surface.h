#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace scanway::simulator {

/// What a surface belongs to: the label of every simulated point. The numbers are in files and never change.
enum class Label : std::uint8_t {
  nothing = 0,
  ground = 1,
  building = 2,
  roof = 3,
  pillar = 4,
  fence = 5,
  pole = 6,
  tree = 7,
  foliage = 8,
  car = 9,
  debris = 10,
  furniture = 11,
  robot = 12,
  person = 13,
};

std::string_view name_of(Label label);

/// What a surface is made of, as the laser sees it at 905 nm.
enum class Material : std::uint8_t {
  asphalt,
  concrete,
  paving,
  grass,
  soil,
  brick,
  plaster,
  wood,
  steel,
  bright_paint,
  dark_paint,
  glass,
  rubber,
  leaf,
  reflector,
};

struct Optics {
  double reflectivity = 0.5;  ///< Of a white sheet held at a right angle to the beam: 1.
  double roughness = 0.5;     ///< 0: falls off with the cosine of incidence; 1: with its square root.
  double relief_m = 0.0;      ///< Standard deviation of the surface about its mesh.
  bool mirrors = false;       ///< Sends the beam back only at nearly right angles.
};

const Optics& optics_of(Material material);

/// What every triangle says of itself.
struct Surface {
  Material material = Material::concrete;
  Label label = Label::nothing;
  bool solid = true;  ///< Part of a closed mesh whose normals point out; leaves, for one, are not.
};

}  // namespace scanway::simulator
