#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "modules/simulator/core/world/mesh.h"

namespace scanway::simulator {

/// A rectangle of the ground plan, metres.
struct Rectangle {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();

  bool contains(double x, double y) const { return x >= low.x() && y >= low.y() && x < high.x() && y < high.y(); }
  Eigen::Vector2d centre() const { return (low + high) / 2; }
  Eigen::Vector2d size() const { return high - low; }
};

/// A part of the ground with a height and a surface of its own: a pavement, a trench, a ramp, a dock.
struct Level {
  Rectangle part;
  double height_m = 0.0;                            ///< At the part's low corner.
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< Metres up a metre along x and y.
  bool on_terrain = true;                           ///< Above the terrain, or above z = 0.
  Material material = Material::concrete;
};

/// The ground: one height over every point of its extent. Where two levels meet at different heights, a vertical face
/// closes the gap. Of levels that overlap the last one counts.
struct GroundPlan {
  using Terrain = std::function<double(double x, double y)>;

  Rectangle extent;
  Material material = Material::asphalt;
  Terrain terrain = [](double, double) { return 0.0; };
  double spacing_m = 1.0;  ///< Of the mesh's vertices, at most.
  std::vector<Level> levels;

  double height(double x, double y) const { return height_in(level_at(x, y), x, y); }
  Mesh mesh() const;

 private:
  const Level* level_at(double x, double y) const;
  double height_in(const Level* level, double x, double y) const;
  std::vector<double> cuts(int axis) const;
  Material material_of(const Level* level) const { return level != nullptr ? level->material : material; }
};

/// Uneven ground: waves of `amplitude_m` and of wavelengths from 5 m up, and bumps of a twentieth of it.
GroundPlan::Terrain uneven(std::uint64_t seed, double amplitude_m);

}  // namespace scanway::simulator
