#include "modules/simulator/core/world/things.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/pose.h"
#include "common/math/repeatable.h"

namespace scanway::simulator {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

Isometry3d at(double x, double y, double z, double heading) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() = rotation_about_z(heading);
  X.translation() = Vector3d(x, y, z);
  return X;
}

Isometry3d tilted_at(double x, double y, double z, double heading, double tilt, double tilt_axis_heading) {
  Isometry3d X = at(x, y, z, heading);
  const Vector3d axis(repeatable::cos(tilt_axis_heading), repeatable::sin(tilt_axis_heading), 0.0);
  X.linear() = exp_so3(axis * tilt) * X.linear();
  return X;
}

double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }

void add_lamp(Mesh& mesh, const Isometry3d& X) {
  const Surface steel{Material::steel, Label::pole};
  add_cylinder(mesh, X, 0.09, -0.2, 0.9, steel, 10);
  add_cylinder(mesh, X, 0.055, 0.9, 5.5, steel, 10, 0.8);
  add_box(mesh, X * Translation3d(0.5, 0, 5.45), {1.1, 0.12, 0.1}, steel);
}

void add_sign(Mesh& mesh, const Isometry3d& X) {
  add_cylinder(mesh, X, 0.035, -0.2, 2.7, {Material::steel, Label::pole}, 8);
  add_box(mesh, X * Translation3d(0.05, 0, 2.4), {0.02, 0.6, 0.6}, {Material::reflector, Label::pole});
}

void add_bollard(Mesh& mesh, const Isometry3d& X) {
  add_cylinder(mesh, X, 0.08, -0.2, 0.9, {Material::bright_paint, Label::pole}, 10);
}

void add_bin(Mesh& mesh, const Isometry3d& X) {
  add_box(mesh, X * Translation3d(0, 0, 0.5), {0.75, 0.6, 1.04}, {Material::dark_paint, Label::furniture});
  add_box(mesh, X * Translation3d(0, 0, 1.06), {0.8, 0.66, 0.08}, {Material::dark_paint, Label::furniture});
}

void add_bench(Mesh& mesh, const Isometry3d& X) {
  const Surface wood{Material::wood, Label::furniture}, concrete{Material::concrete, Label::furniture};
  add_box(mesh, X * Translation3d(0, 0, 0.45), {0.45, 1.8, 0.06}, wood);
  add_box(mesh, X * Translation3d(-0.24, 0, 0.75), {0.05, 1.8, 0.35}, wood);
  for (const double y : {-0.7, 0.7}) add_box(mesh, X * Translation3d(0, y, 0.2), {0.4, 0.1, 0.5}, concrete);
}

void add_crates(Mesh& mesh, const Isometry3d& X, Random& random) {
  const int high = 1 + static_cast<int>(random.below(3));
  double z = 0.0;
  for (int i = 0; i < high; ++i) {
    const Surface wood{Material::wood, Label::furniture};
    const double height = between(random, 0.35, 0.75);
    const Isometry3d layer =
        X * at(between(random, -0.05, 0.05), between(random, -0.05, 0.05), z, between(random, -0.1, 0.1));
    for (const double y : {-0.34, 0.0, 0.34}) {  // The pallet's feet.
      add_box(mesh, layer * Translation3d(0, y, 0.05), {1.2, 0.1, 0.1}, wood);
    }
    add_box(mesh, layer * Translation3d(0, 0, 0.12), {1.2, 0.8, 0.04}, wood);
    add_box(mesh, layer * Translation3d(0, 0, 0.14 + height / 2), {1.1, 0.75, height},
            {Material::plaster, Label::furniture});
    z += 0.14 + height;
  }
}

void add_container(Mesh& mesh, const Isometry3d& X, double length) {
  const Surface steel{Material::bright_paint, Label::furniture};
  add_box(mesh, X * Translation3d(0, 0, 1.3), {length, 2.38, 2.6}, steel);
  const int ribs = static_cast<int>(length / 0.28);
  for (int i = 0; i <= ribs; ++i) {
    const double x = -length / 2 + length * i / ribs;
    for (const double side : {-1.21, 1.21}) add_box(mesh, X * Translation3d(x, side, 1.3), {0.1, 0.06, 2.5}, steel);
  }
}

void add_machine(Mesh& mesh, const Isometry3d& X, Random& random) {
  const double length = between(random, 1.5, 3.2), width = between(random, 1.0, 1.8),
               height = between(random, 0.9, 1.6);
  add_box(mesh, X * Translation3d(0, 0, height / 2 - 0.05), {length, width, height},
          {Material::bright_paint, Label::furniture});
  add_box(mesh, X * Translation3d(-length / 4, width / 8, height + 0.4), {length / 2, width / 2, 1.0},
          {Material::steel, Label::furniture});
  add_cylinder(mesh, X * Translation3d(length / 3, 0, height), 0.18, -0.1, between(random, 0.6, 1.8),
               {Material::steel, Label::furniture});
  add_box(mesh, X * Translation3d(length / 4, -width / 2 - 0.2, 0.6), {0.6, 0.4, 1.25},
          {Material::plaster, Label::furniture});
}

void add_shelf(Mesh& mesh, const Isometry3d& X, double length, Random& random) {
  const Surface steel{Material::steel, Label::furniture};
  const int bays = std::max(1, static_cast<int>(length / 2.7));
  const double bay = length / bays;
  for (int i = 0; i <= bays; ++i) {
    for (const double y : {-0.5, 0.5})
      add_box(mesh, X * Translation3d(i * bay - length / 2, y, 2.0), {0.1, 0.08, 4.05}, steel);
  }
  for (const double z : {0.15, 1.6, 3.05}) {
    for (const double y : {-0.5, 0.5}) add_box(mesh, X * Translation3d(0, y, z), {length, 0.05, 0.12}, steel);
    for (int i = 0; i < 2 * bays; ++i) {
      if (random.below(4) == 0) continue;
      const double height = between(random, 0.4, 1.2), x = (i + 0.5) * bay / 2 - length / 2;
      add_box(mesh, X * Translation3d(x, 0, z + 0.06 + height / 2), {bay / 2 - 0.15, between(random, 0.7, 1.0), height},
              {Material::wood, Label::furniture});
    }
  }
}

void add_fence(Mesh& mesh, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double length = along.norm(), heading = repeatable::atan2(along.y(), along.x());
  const Surface wood{Material::wood, Label::fence};
  const int posts = std::max(1, static_cast<int>(std::ceil(length / 2.0)));
  const auto on = [&](double share, double z) {
    const Vector3d p = a + share * along;
    return at(p.x(), p.y(), p.z() + z, heading);
  };
  for (int i = 0; i <= posts; ++i) add_box(mesh, on(static_cast<double>(i) / posts, 0.6), {0.1, 0.1, 1.6}, wood);
  const int boards = std::max(1, static_cast<int>(length / 0.22));
  for (int i = 0; i < boards; ++i) add_box(mesh, on((i + 0.5) / boards, 0.7), {0.14, 0.02, 1.3}, wood);
}

}  // namespace scanway::simulator
