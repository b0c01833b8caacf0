#include "modules/simulator/core/world/ground_plan.h"

#include <algorithm>
#include <cmath>

#include "common/math/repeatable.h"
#include "common/random/random.h"

namespace scanway::simulator {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSameCut = 1e-6;
constexpr double kSameHeight = 1e-9;

/// The upright face between two neighbouring cells along the edge from p to q, at heights (p, q) of one and the other.
void add_riser(Mesh& mesh, const Vector2d& p, const Vector2d& q, const Vector2d& one, const Vector2d& other,
               Surface surface) {
  if ((one - other).cwiseAbs().maxCoeff() < kSameHeight) return;
  mesh.add_quad({p.x(), p.y(), one[0]}, {q.x(), q.y(), one[1]}, {q.x(), q.y(), other[1]}, {p.x(), p.y(), other[0]},
                surface);
}

}  // namespace

const Level* GroundPlan::level_at(double x, double y) const {
  const auto found =
      std::find_if(levels.rbegin(), levels.rend(), [&](const Level& level) { return level.part.contains(x, y); });
  return found != levels.rend() ? &*found : nullptr;
}

double GroundPlan::height_in(const Level* level, double x, double y) const {
  if (level == nullptr) return terrain(x, y);
  const double own = level->height_m + level->slope.dot(Vector2d(x, y) - level->part.low);
  return level->on_terrain ? own + terrain(x, y) : own;
}

std::vector<double> GroundPlan::cuts(int axis) const {
  std::vector<double> at = {extent.low[axis], extent.high[axis]};
  for (const Level& level : levels) {
    for (const double edge : {level.part.low[axis], level.part.high[axis]}) {
      if (edge > extent.low[axis] && edge < extent.high[axis]) at.push_back(edge);
    }
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end(), [](double a, double b) { return b - a < kSameCut; }), at.end());
  std::vector<double> fine = {at[0]};
  for (std::size_t i = 1; i < at.size(); ++i) {
    const int parts = static_cast<int>(std::ceil((at[i] - at[i - 1]) / spacing_m));
    for (int part = 1; part <= parts; ++part) fine.push_back(at[i - 1] + (at[i] - at[i - 1]) * part / parts);
  }
  return fine;
}

Mesh GroundPlan::mesh() const {
  const std::vector<double> xs = cuts(0), ys = cuts(1);
  const auto level_of = [&](std::size_t i, std::size_t j) {
    return level_at((xs[i] + xs[i + 1]) / 2, (ys[j] + ys[j + 1]) / 2);
  };
  Mesh mesh;
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      const Level* here = level_of(i, j);
      const auto z = [&](const Level* level, std::size_t a, std::size_t b) { return height_in(level, xs[a], ys[b]); };
      const auto corner = [&](std::size_t a, std::size_t b) { return Vector3d(xs[a], ys[b], z(here, a, b)); };
      const Surface surface{material_of(here), Label::ground, false};
      mesh.add_triangle(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), surface);
      mesh.add_triangle(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1), surface);
      const auto close = [&](const Level* next, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
        const bool higher = z(here, a, b) + z(here, c, d) > z(next, a, b) + z(next, c, d);
        add_riser(mesh, {xs[a], ys[b]}, {xs[c], ys[d]}, {z(here, a, b), z(here, c, d)}, {z(next, a, b), z(next, c, d)},
                  {material_of(higher ? here : next), Label::ground, false});
      };
      if (i + 2 < xs.size()) close(level_of(i + 1, j), i + 1, j, i + 1, j + 1);
      if (j + 2 < ys.size()) close(level_of(i, j + 1), i, j + 1, i + 1, j + 1);
    }
  }
  return mesh;
}

GroundPlan::Terrain uneven(std::uint64_t seed, double amplitude_m) {
  struct Wave {
    Vector2d k;  // Radians a metre.
    double phase, amplitude;
  };
  std::vector<Wave> waves;
  Random random(seed);
  for (const double length : {21.0, 13.0, 8.0, 5.0, 1.7, 1.3}) {
    const double angle = 2.0 * repeatable::kPi * random.uniform();
    const Vector2d direction(repeatable::cos(angle), repeatable::sin(angle));
    const double part = length > 2.0 ? length / 47.0 : 0.025;  // The long ones add up to 1.
    waves.push_back(
        {direction * (2.0 * repeatable::kPi / length), 2.0 * repeatable::kPi * random.uniform(), part * amplitude_m});
  }
  return [waves](double x, double y) {
    double z = 0.0;
    for (const Wave& wave : waves) z += wave.amplitude * repeatable::sin(wave.k.dot(Vector2d(x, y)) + wave.phase);
    return z;
  };
}

}  // namespace scanway::simulator
