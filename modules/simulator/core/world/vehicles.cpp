#include <array>

#include "modules/simulator/core/world/things.h"

namespace scanway::simulator {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kQuarterTurn = 1.5707963267948966;

/// A frame whose x is ahead, y up and z to the right of X: a side view drawn in x-y is drawn out across the vehicle.
Isometry3d side_view(const Isometry3d& X) {
  Isometry3d Y = X;
  Y.linear() = X.linear() * (Eigen::Matrix3d() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
  return Y;
}

void add_wheels(Mesh& mesh, const Isometry3d& X, std::initializer_list<double> axles, double half_track,
                double radius) {
  for (const double x : axles) {
    for (const double side : {-half_track, half_track}) {
      Isometry3d wheel = side_view(X) * Eigen::Translation3d(x, radius - 0.01, -side);
      add_cylinder(mesh, wheel, radius, -0.1, 0.1, {Material::rubber, Label::car}, 14);
    }
  }
}

Material paint(Random& random) {
  constexpr std::array kPaints = {Material::bright_paint, Material::bright_paint, Material::dark_paint,
                                  Material::steel};
  return kPaints[random.below(kPaints.size())];
}

void add_plate(Mesh& mesh, const Isometry3d& X, double x) {
  add_box(mesh, X * Eigen::Translation3d(x, 0, 0.45), {0.03, 0.5, 0.11}, {Material::reflector, Label::car});
}

}  // namespace

void add_car(Mesh& mesh, const Isometry3d& X, Random& random) {
  const double scale = between(random, 0.9, 1.08), half_width = 0.87 * between(random, 0.96, 1.05);
  const Material body = paint(random);
  const auto scaled = [&](std::vector<Vector2d> outline) {
    for (Vector2d& p : outline) p.x() *= scale;
    return outline;
  };
  const bool estate = random.below(2) == 0;
  const auto lower = scaled(
      {{-2.1, 0.32}, {-1.95, 0.18}, {1.95, 0.18}, {2.12, 0.34}, {2.08, 0.66}, {1.0, 0.92}, {-2.0, 0.92}, {-2.13, 0.6}});
  const auto cabin = scaled({{-1.75, 0.9}, {1.05, 0.9}, {0.35, 1.44}, {estate ? -1.55 : -1.0, 1.46}});
  add_prism(mesh, side_view(X), lower, -half_width, half_width, {body, Label::car});
  add_prism(mesh, side_view(X), cabin, -half_width + 0.08, half_width - 0.08, {Material::glass, Label::car});
  add_box(mesh, X * Eigen::Translation3d(-0.45 * scale, 0, 1.47), {1.3, 1.5, 0.05}, {body, Label::car});
  for (const double side : {-1.0, 1.0}) {
    add_box(mesh, X * Eigen::Translation3d(0.75 * scale, side * (half_width + 0.08), 0.98), {0.1, 0.16, 0.13},
            {body, Label::car});
  }
  add_wheels(mesh, X, {-1.3 * scale, 1.32 * scale}, half_width - 0.09, 0.32);
  add_plate(mesh, X, 2.12 * scale);
  add_plate(mesh, X, -2.12 * scale);
}

void add_van(Mesh& mesh, const Isometry3d& X, Random& random) {
  const Surface body{paint(random), Label::car};
  const std::vector<Vector2d> outline = {{-2.6, 0.25}, {2.55, 0.25}, {2.6, 0.9}, {2.0, 1.15}, {1.4, 2.0}, {-2.6, 2.05}};
  add_prism(mesh, side_view(X), outline, -0.98, 0.98, body);
  add_wheels(mesh, X, {-1.6, 1.7}, 0.88, 0.35);
  add_plate(mesh, X, -2.6);
}

void add_lorry(Mesh& mesh, const Isometry3d& X, Random& random) {
  add_box(mesh, X * Eigen::Translation3d(-1.0, 0, 2.35), {7.2, 2.5, 2.6}, {Material::bright_paint, Label::car});
  add_box(mesh, X * Eigen::Translation3d(0.3, 0, 0.85), {9.0, 0.9, 0.35}, {Material::steel, Label::car});
  const std::vector<Vector2d> cab = {{2.75, 0.5}, {4.9, 0.5}, {4.9, 1.6}, {4.6, 2.9}, {2.75, 3.0}};
  add_prism(mesh, side_view(X), cab, -1.2, 1.2, {paint(random), Label::car});
  add_wheels(mesh, X, {-3.4, -2.2, 3.7}, 1.05, 0.5);
  add_plate(mesh, X, -4.55);
}

}  // namespace scanway::simulator
