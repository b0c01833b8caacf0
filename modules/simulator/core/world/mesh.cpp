#include "modules/simulator/core/world/mesh.h"

#include "common/math/repeatable.h"

namespace scanway::simulator {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Corners Mesh::corners(std::size_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle];
  return {vertices_[a].cast<double>(), vertices_[b].cast<double>(), vertices_[c].cast<double>()};
}

std::uint32_t Mesh::add_vertex(const Vector3d& vertex) {
  vertices_.push_back(vertex.cast<float>());
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

void Mesh::add_polygon(std::span<const Vector3d> outline, Surface surface) {
  const std::uint32_t first = add_vertex(outline[0]);
  std::uint32_t last = add_vertex(outline[1]);
  for (std::size_t i = 2; i < outline.size(); ++i) {
    const std::uint32_t next = add_vertex(outline[i]);
    triangles_.push_back({first, last, next});
    surfaces_.push_back(surface);
    last = next;
  }
}

void Mesh::add_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c, Surface surface) {
  add_polygon(std::array{a, b, c}, surface);
}

void Mesh::add_quad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d, Surface surface) {
  add_polygon(std::array{a, b, c, d}, surface);
}

void add_prism(Mesh& mesh, const Isometry3d& X, std::span<const Vector2d> outline, double low, double high,
               Surface surface, double taper) {
  std::vector<Vector3d> bottom, top;
  for (const Vector2d& p : outline) {
    bottom.push_back(X * Vector3d(p.x(), p.y(), low));
    top.push_back(X * Vector3d(p.x() * taper, p.y() * taper, high));
  }
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    mesh.add_quad(bottom[i], bottom[next], top[next], top[i], surface);
  }
  mesh.add_polygon(top, surface);
  mesh.add_polygon(std::vector<Vector3d>(bottom.rbegin(), bottom.rend()), surface);
}

void add_box(Mesh& mesh, const Isometry3d& X, const Vector3d& size, Surface surface) {
  const double x = size.x() / 2, y = size.y() / 2;
  const std::array<Vector2d, 4> outline = {Vector2d(-x, -y), Vector2d(x, -y), Vector2d(x, y), Vector2d(-x, y)};
  add_prism(mesh, X, outline, -size.z() / 2, size.z() / 2, surface);
}

void add_block(Mesh& mesh, const Vector3d& low, const Vector3d& high, Surface surface) {
  const std::array<Vector2d, 4> outline = {Vector2d(low.x(), low.y()), Vector2d(high.x(), low.y()),
                                           Vector2d(high.x(), high.y()), Vector2d(low.x(), high.y())};
  add_prism(mesh, Isometry3d::Identity(), outline, low.z(), high.z(), surface);
}

void add_cylinder(Mesh& mesh, const Isometry3d& X, double radius, double low, double high, Surface surface, int sides,
                  double taper) {
  std::vector<Vector2d> outline;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * repeatable::kPi * i / sides;
    outline.emplace_back(radius * repeatable::cos(angle), radius * repeatable::sin(angle));
  }
  add_prism(mesh, X, outline, low, high, surface, taper);
}

}  // namespace scanway::simulator
