#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "modules/simulator/core/world/surface.h"

namespace scanway::simulator {

using Corners = std::array<Eigen::Vector3d, 3>;

/// Triangles in metres; seen from outside their corners go counter-clockwise. Coordinates are kept as floats, which is
/// what the ray caster takes: geometry computed from the mesh in double is the geometry that the rays meet.
class Mesh {
 public:
  std::size_t size() const { return triangles_.size(); }
  Corners corners(std::size_t triangle) const;
  const Surface& surface(std::size_t triangle) const { return surfaces_[triangle]; }
  const std::vector<Eigen::Vector3f>& vertices() const { return vertices_; }
  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }

  void add_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, Surface surface);
  /// a, b, c, d counter-clockwise seen from outside, in one plane.
  void add_quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d,
                Surface surface);
  /// A convex outline, counter-clockwise seen from outside, in one plane.
  void add_polygon(std::span<const Eigen::Vector3d> outline, Surface surface);

 private:
  std::uint32_t add_vertex(const Eigen::Vector3d& vertex);

  std::vector<Eigen::Vector3f> vertices_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Surface> surfaces_;
};

// Closed bodies. X places the body's own frame in the world.

/// A box of `size` about the origin of its frame.
void add_box(Mesh& mesh, const Eigen::Isometry3d& X, const Eigen::Vector3d& size, Surface surface);
/// A box between two corners along the world's axes.
void add_block(Mesh& mesh, const Eigen::Vector3d& low, const Eigen::Vector3d& high, Surface surface);
/// A convex outline in the frame's x-y plane, counter-clockwise, drawn out along z from `low` to `high`; with `taper`
/// the upper end is the outline times it.
void add_prism(Mesh& mesh, const Eigen::Isometry3d& X, std::span<const Eigen::Vector2d> outline, double low,
               double high, Surface surface, double taper = 1.0);
/// A prism of `sides` sides about the frame's z.
void add_cylinder(Mesh& mesh, const Eigen::Isometry3d& X, double radius, double low, double high, Surface surface,
                  int sides = 12, double taper = 1.0);

}  // namespace scanway::simulator
