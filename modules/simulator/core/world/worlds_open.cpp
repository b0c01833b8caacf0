#include "common/math/repeatable.h"
#include "modules/simulator/core/world/builders.h"
#include "modules/simulator/core/world/building.h"
#include "modules/simulator/core/world/things.h"

/// Worlds of ground: flat, slope, ramp, trench, field.
namespace scanway::simulator {
namespace {

using Eigen::Vector3d;

constexpr double kTangent4 = 0.06992681194351041;   // tan of 4 degrees
constexpr double kTangent10 = 0.17632698070846498;  // tan of 10 degrees

/// Boxes, posts, walls and trees on ground of any slope: what stands on it stands upright.
void add_court(World& world, const GroundPlan& plan, Random& random) {
  Mesh& mesh = world.objects;
  const auto ground = [&](double x, double y) { return plan.height(x, y); };
  const Surface brick{Material::brick, Label::building};
  // Walls are set in pieces, each at the ground's height of its own.
  for (double x = -17; x < 16; x += 3) add_wall(mesh, {x, 14.5}, {x + 3, 14.5}, ground(x + 1.5, 14.5), 2.4, 0.3, brick);
  for (double y = -14; y < 8; y += 3)
    add_wall(mesh, {-19.5, y}, {-19.5, y + 3}, ground(-19.5, y + 1.5), 1.6, 0.25, brick);
  add_building(
      mesh, {{{10, -15.8}, {18, between(random, -11, -9.5)}}, ground(14, -13), 2, 3.0, 2.8, Material::plaster, false},
      random);
  for (int i = 0; i < 9; ++i) {
    const double x = between(random, -16, 17), y = i % 2 == 0 ? between(random, 4, 12) : between(random, -12, -4);
    const double size = between(random, 0.25, 1.1);
    add_box(mesh, at(x, y, ground(x, y) + size / 2 - 0.1, kTurn * random.uniform()), {size * 1.3, size, size + 0.2},
            {Material::wood, Label::furniture});
  }
  for (int i = 0; i < 6; ++i) {
    const double x = between(random, -17, 17),
                 y = between(random, 0, 1) < 0.5 ? between(random, -9, -3.5) : between(random, 3.5, 11);
    add_bollard(mesh, at(x, y, ground(x, y)));
  }
  for (int i = 0; i < 3; ++i) {
    const double x = -12 + 9.0 * i + between(random, -2, 2), y = between(random, 11.5, 13);
    add_tree(mesh, at(x, y, ground(x, y)), random);
  }
  add_container(mesh, at(-13, -11, ground(-13, -11) - 0.2, between(random, -0.3, 0.3)), 6.06);
  add_crates(mesh, at(between(random, -3, 3), -11, ground(0, -11) - 0.1, kTurn * random.uniform()), random);
}

}  // namespace

void build_flat(World& world) {
  Random random(world.seed * 16 + 5);
  GroundPlan plan;
  plan.extent = {{-20, -16}, {20, 16}};
  plan.material = Material::concrete;
  world.extent = plan.extent;
  add_court(world, plan, random);
  world.ground = plan.mesh();
  world.route = {{-16, 0}, {0, 1}, {16, -1}};
}

void build_slope(World& world) {
  Random random(world.seed * 16 + 6);
  GroundPlan plan;
  plan.extent = {{-20, -16}, {20, 16}};
  plan.terrain = [](double x, double) { return kTangent10 * x; };
  world.extent = plan.extent;
  add_court(world, plan, random);
  world.ground = plan.mesh();
  world.route = {{-16, 0}, {0, 1}, {16, -1}};
}

void build_ramp(World& world) {
  Random random(world.seed * 16 + 7);
  GroundPlan plan;
  plan.extent = {{-25, -16}, {25, 16}};
  const auto bumps = uneven(random.next(), 0.03);
  plan.terrain = [bumps](double x, double y) { return kTangent4 * x + bumps(x, y); };
  // A dock of even height along the building, and a ramp of 12 m up to it, at 7 degrees from where it leaves the slope.
  const double dock = 2.3, ramp_x = between(random, -6, -3), low = kTangent4 * ramp_x;
  plan.levels = {{{{ramp_x + 12.0, 7}, {22, 11}}, dock, {0, 0}, false, Material::concrete},
                 {{{ramp_x, 7.5}, {ramp_x + 12.0, 10}}, low, {(dock - low) / 12.0, 0}, false, Material::concrete}};
  world.extent = plan.extent;
  Mesh& mesh = world.objects;
  const auto ground = [&](double x, double y) { return plan.height(x, y); };
  add_building(mesh, {{{ramp_x + 12.0, 11}, {22, 15.8}}, dock, 1, 5.0, 4.5, Material::concrete, true}, random);
  add_building(mesh,
               {{{-24.8, 9}, {between(random, -16, -13), 15.8}}, ground(-16, 9), 2, 3.0, 3.2, Material::brick, false},
               random);
  add_wall(mesh, {ramp_x, 10.15}, {ramp_x + 12, 10.15}, low, dock - low + 1.0, 0.2,
           {Material::concrete, Label::building});
  for (const double x : {12.5, 17.0})
    add_lorry(mesh, at(x + between(random, -0.3, 0.3), 1.4, ground(x, 3), -kQuarter), random);
  for (int i = 0; i < 5; ++i) {
    const double x = between(random, -20, 18), y = between(random, -12.5, -8);
    add_crates(mesh, at(x, y, ground(x, y) - 0.03, kTurn * random.uniform()), random);
  }
  for (int i = 0; i < 5; ++i)
    add_tree(mesh, at(-20 + 9.5 * i, -14 + between(random, -1, 1), ground(-20 + 9.5 * i, -14)), random);
  for (double x = -24; x < 23; x += 6.0)
    add_fence(mesh, {x, -15.6, ground(x, -15.6)}, {x + 5.8, -15.6, ground(x + 5.8, -15.6)});
  for (int i = 0; i < 4; ++i) add_bollard(mesh, at(ramp_x - 0.8, 6.2 + 1.5 * i, ground(ramp_x - 0.8, 7)));
  add_car(mesh, at(-12, between(random, 5, 7), ground(-12, 6), between(random, -0.2, 0.2)), random);
  world.ground = plan.mesh();
  world.route = {{-20, -2}, {0, -4}, {20, -5.5}};
}

void build_trench(World& world) {
  Random random(world.seed * 16 + 8);
  GroundPlan plan;
  plan.extent = {{-22, -18}, {22, 18}};
  plan.material = Material::soil;
  plan.terrain = uneven(random.next(), 0.05);
  const double x = between(random, -9, -7), y = between(random, 3.5, 4.5), deep = -1.2;
  plan.levels = {{{{x, y}, {14, y + 0.9}}, deep, {0, 0}, true, Material::soil},
                 {{{x, -12}, {x + 0.9, y + 0.9}}, deep, {0, 0}, true, Material::soil},
                 {{{2, -13}, {6, -10}}, -0.4, {0, 0}, true, Material::soil},
                 {{{x - 0.2, -4.2}, {x + 1.1, -2.7}}, 0.0, {0, 0}, true, Material::wood}};  // A bridge over it.
  world.extent = plan.extent;
  Mesh& mesh = world.objects;
  const auto ground = [&](double px, double py) { return plan.height(px, py); };
  add_building(mesh,
               {{{-21.8, 13.5}, {between(random, 4, 9), 17.8}}, ground(-8, 13.5), 2, 3.1, 3.4, Material::brick, false},
               random);
  add_container(mesh, at(17.5, between(random, -8, -4), ground(17.5, -6), kQuarter), 6.06);
  for (int i = 0; i < 5; ++i) {  // Heaps of what was dug out.
    const double hx = -4.5 + 3.6 * i, hy = y + 3.4;
    add_cylinder(mesh, at(hx, hy, ground(hx, hy), kTurn * random.uniform()), between(random, 1.3, 1.8), -0.3,
                 between(random, 0.7, 1.1), {Material::soil, Label::debris}, 14, 0.2);
  }
  for (double fx = x + 1.5; fx < 10; fx += 4.2)
    add_fence(mesh, {fx, y - 1.2, ground(fx, y - 1.2)}, {fx + 2.4, y - 1.2, ground(fx + 2.4, y - 1.2)});
  for (int i = 0; i < 4; ++i) {  // Pipes beside the trench.
    Eigen::Isometry3d pipe = at(x - 2.0 - 0.5 * i, -8, ground(x - 2, -8) + 0.19);
    pipe.linear() = pipe.linear() * (Eigen::Matrix3d() << 1, 0, 0, 0, 0, 1, 0, -1, 0).finished();
    add_cylinder(mesh, pipe, 0.2, -3, 3, {Material::concrete, Label::debris}, 14);
  }
  for (int i = 0; i < 5; ++i) {
    const double cx = between(random, -18, 18), cy = between(random, -16.5, -13.8);
    add_crates(mesh, at(cx, cy, ground(cx, cy), kTurn * random.uniform()), random);
  }
  for (int i = 0; i < 3; ++i) add_tree(mesh, at(-19.5, -12 + 8.0 * i, ground(-19.5, -12 + 8.0 * i)), random);
  add_lorry(mesh, at(between(random, 8, 11), 13.5, ground(9, 13.5), between(random, -0.1, 0.1)), random);
  add_van(mesh, at(12, -14.5, ground(12, -14.5), between(random, -0.2, 0.2)), random);
  world.ground = plan.mesh();
  world.route = {{-4, -6}, {2, 0}, {12, 0.5}, {13, -8}};
}

void build_field(World& world) {
  Random random(world.seed * 16 + 9);
  GroundPlan plan;
  plan.extent = {{-35, -35}, {35, 35}};
  plan.material = Material::grass;
  plan.terrain = uneven(random.next(), 0.05);
  world.extent = plan.extent;
  world.ground = plan.mesh();
  world.route = {{-18, 0}, {18, 0}};
}

}  // namespace scanway::simulator
