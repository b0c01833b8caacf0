#include "common/geometry/pose.h"
#include "common/math/repeatable.h"
#include "modules/simulator/core/world/things.h"

namespace scanway::simulator {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Vector3d in_unit_ball(Random& random) {
  for (;;) {
    const Vector3d p(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1));
    if (p.squaredNorm() <= 1.0) return p;
  }
}

/// Leaves in an ellipsoid about `centre`: small triangles every way round.
void add_leaves(Mesh& mesh, const Vector3d& centre, const Vector3d& radii, int count, double size, Random& random) {
  const Surface leaf{Material::leaf, Label::foliage, false};
  for (int i = 0; i < count; ++i) {
    // Most leaves of a crown are on its outside.
    const Vector3d inner = in_unit_ball(random);
    const Vector3d p = centre + radii.cwiseProduct(inner * (0.6 + 0.4 / std::max(0.4, inner.norm())));
    mesh.add_triangle(p, p + size * in_unit_ball(random), p + size * in_unit_ball(random), leaf);
  }
}

}  // namespace

void add_tree(Mesh& mesh, const Isometry3d& X, Random& random) {
  const double height = between(random, 2.3, 3.2), radius = between(random, 0.1, 0.2);
  const double crown = between(random, 1.3, 2.2);
  add_cylinder(mesh, X, radius, -0.3, height + 1.0, {Material::wood, Label::tree}, 10, 0.6);
  for (int i = 0; i < 5; ++i) {
    const double heading = 2.0 * repeatable::kPi * (i + random.uniform()) / 5;
    Isometry3d branch = X * Eigen::Translation3d(0, 0, between(random, height - 0.5, height + 0.6));
    branch.linear() = branch.linear() * rotation_about_z(heading) * exp_so3(Vector3d(0, between(random, 0.6, 1.1), 0));
    add_cylinder(mesh, branch, radius * 0.4, 0.0, crown * 0.8, {Material::wood, Label::tree}, 6, 0.4);
  }
  add_leaves(mesh, X * Vector3d(0, 0, height + 0.8 * crown), {crown, crown, 0.8 * crown}, 500, 0.3, random);
}

void add_bush(Mesh& mesh, const Isometry3d& X, double radius, Random& random) {
  add_leaves(mesh, X * Vector3d(0, 0, 0.55 * radius), {radius, radius, 0.6 * radius}, 260, 0.16, random);
}

}  // namespace scanway::simulator
