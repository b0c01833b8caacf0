#include "modules/simulator/core/world/building.h"

#include <algorithm>
#include <cmath>

#include "common/math/repeatable.h"
#include "modules/simulator/core/world/things.h"

namespace scanway::simulator {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFoundation = 0.6;

/// One side of a building: `u` runs along it, to the right as one stands before it; `out` points away from it.
struct Side {
  Vector2d origin, along, out;
  double length = 0.0;

  Vector3d point(double u, double depth, double z) const {
    const Vector2d p = origin + u * along - depth * out;
    return {p.x(), p.y(), z};
  }
};

/// What a bay's opening looks like, metres within the bay.
struct Opening {
  double width = 1.2, low = 0.9, high = 2.3, depth = 0.15;
  Material filling = Material::glass;
};

std::vector<Side> sides_of(const Rectangle& plan) {
  const double x0 = plan.low.x(), y0 = plan.low.y(), x1 = plan.high.x(), y1 = plan.high.y();
  return {{{x0, y0}, {1, 0}, {0, -1}, x1 - x0},
          {{x1, y0}, {0, 1}, {1, 0}, y1 - y0},
          {{x1, y1}, {-1, 0}, {0, 1}, x1 - x0},
          {{x0, y1}, {0, -1}, {-1, 0}, y1 - y0}};
}

/// The wall of one bay of one storey, with its opening set back into it.
void add_bay(Mesh& mesh, const Side& side, double u0, double u1, double z0, double z1, const Opening& opening,
             Surface wall) {
  const double middle = (u0 + u1) / 2, a = middle - opening.width / 2, b = middle + opening.width / 2;
  const double low = z0 + opening.low, high = z0 + opening.high, deep = opening.depth;
  const auto face = [&](double ua, double ub, double za, double zb, double depth, Surface surface) {
    mesh.add_quad(side.point(ua, depth, za), side.point(ub, depth, za), side.point(ub, depth, zb),
                  side.point(ua, depth, zb), surface);
  };
  face(u0, a, z0, z1, 0, wall);
  face(b, u1, z0, z1, 0, wall);
  face(a, b, z0, low, 0, wall);
  face(a, b, high, z1, 0, wall);
  face(a, b, low, high, deep, {opening.filling, wall.label});
  mesh.add_quad(side.point(a, 0, low), side.point(b, 0, low), side.point(b, deep, low), side.point(a, deep, low), wall);
  mesh.add_quad(side.point(a, deep, high), side.point(b, deep, high), side.point(b, 0, high), side.point(a, 0, high),
                wall);
  mesh.add_quad(side.point(a, 0, low), side.point(a, deep, low), side.point(a, deep, high), side.point(a, 0, high),
                wall);
  mesh.add_quad(side.point(b, deep, low), side.point(b, 0, low), side.point(b, 0, high), side.point(b, deep, high),
                wall);
}

Opening opening_of(const Building& building, int storey, bool door, Random& random) {
  const double top = std::min(building.storey_m - 0.5, 2.3);
  if (storey == 0 && building.gates) return {building.bay_m * 0.75, 0.0, building.storey_m - 0.4, 0.3, Material::steel};
  if (storey == 0 && door) return {1.1, 0.0, 2.1, 0.25, Material::wood};
  const bool shut = random.below(4) == 0;
  return {1.2, 0.9, top, shut ? 0.05 : 0.15, shut ? Material::wood : Material::glass};
}

/// What the owners added to one bay: a downpipe, a balcony, a cooler.
void add_owners_things(Mesh& mesh, const Side& side, double u, double bay, double z, int storey, Random& random) {
  const double heading = repeatable::atan2(side.along.y(), side.along.x());
  const auto place = [&](double at_u, double out, double at_z) {
    const Vector3d p = side.point(at_u, -out, at_z);
    return at(p.x(), p.y(), p.z(), heading);
  };
  const Surface steel{Material::steel, Label::building}, concrete{Material::concrete, Label::building};
  const std::uint64_t which = random.below(9);
  if (which == 0 && storey > 0) {
    add_box(mesh, place(u + bay / 2, 0.5, z + 0.06), {bay * 0.8, 1.0, 0.14}, concrete);
    add_box(mesh, place(u + bay / 2, 0.98, z + 0.55), {bay * 0.8, 0.05, 0.95}, steel);
  }
  if (which == 1)
    add_box(mesh, place(u + 0.35, 0.17, z + 1.9), {0.8, 0.34, 0.6}, {Material::bright_paint, Label::building});
  if (which == 2 && storey == 0) add_box(mesh, place(u + 0.3, 0.1, z + 0.8), {0.5, 0.2, 0.9}, steel);
}

void add_side(Mesh& mesh, const Building& building, const Side& side, Random& random) {
  const Surface wall{building.wall, Label::building};
  const int bays = std::max(1, static_cast<int>(std::lround(side.length / building.bay_m)));
  const double bay = side.length / bays;
  const auto door = static_cast<int>(random.below(static_cast<std::uint64_t>(bays)));
  for (int storey = 0; storey < building.storeys; ++storey) {
    const double z = building.ground_m + storey * building.storey_m;
    for (int i = 0; i < bays; ++i) {
      add_bay(mesh, side, i * bay, (i + 1) * bay, z, z + building.storey_m,
              opening_of(building, storey, i == door, random), wall);
      if (i != door) add_owners_things(mesh, side, i * bay, bay, z, storey, random);
    }
  }
  const double top = building.ground_m + building.storeys * building.storey_m;
  for (int i = 2; i < bays; i += 3) {
    const Vector3d p = side.point(i * bay, -0.06, 0);
    add_cylinder(mesh, at(p.x(), p.y(), building.ground_m), 0.05, -0.2, top - building.ground_m,
                 {Material::steel, Label::building}, 8);
  }
  const double below = building.ground_m - kFoundation;
  mesh.add_quad(side.point(0, 0, below), side.point(side.length, 0, below),
                side.point(side.length, 0, building.ground_m), side.point(0, 0, building.ground_m), wall);
}

}  // namespace

void add_building(Mesh& mesh, const Building& building, Random& random) {
  for (const Side& side : sides_of(building.plan)) add_side(mesh, building, side, random);
  const auto& [low, high] = building.plan;
  const double bottom = building.ground_m - kFoundation, top = building.ground_m + building.storeys * building.storey_m;
  const Surface roof{Material::concrete, Label::roof};
  mesh.add_quad({low.x(), low.y(), top}, {high.x(), low.y(), top}, {high.x(), high.y(), top}, {low.x(), high.y(), top},
                roof);
  mesh.add_quad({low.x(), low.y(), bottom}, {low.x(), high.y(), bottom}, {high.x(), high.y(), bottom},
                {high.x(), low.y(), bottom}, roof);
  // The eaves stand out over the walls.
  add_block(mesh, {low.x() - 0.3, low.y() - 0.3, top}, {high.x() + 0.3, high.y() + 0.3, top + 0.25}, roof);
}

void add_wall(Mesh& mesh, const Vector2d& a, const Vector2d& b, double ground_m, double height, double thickness,
              Surface surface) {
  const Vector2d along = b - a, middle = (a + b) / 2;
  add_box(mesh,
          at(middle.x(), middle.y(), ground_m + height / 2 - kFoundation / 2, repeatable::atan2(along.y(), along.x())),
          {along.norm(), thickness, height + kFoundation}, surface);
}

}  // namespace scanway::simulator
