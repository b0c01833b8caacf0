#include <array>

#include "common/math/repeatable.h"
#include "modules/simulator/core/world/builders.h"
#include "modules/simulator/core/world/building.h"
#include "modules/simulator/core/world/things.h"

/// Worlds among houses: yard, street, car park, kerbs.
namespace scanway::simulator {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Turns a thing a little, as people park and put things.
double about(Random& random, double heading, double spread = 0.08) {
  return heading + between(random, -spread, spread);
}

void add_vehicle(World& world, const GroundPlan& plan, double x, double y, double heading, Random& random) {
  const Eigen::Isometry3d X = at(x, y, plan.height(x, y), heading);
  if (random.below(7) == 0) {
    add_van(world.objects, X, random);
  } else {
    add_car(world.objects, X, random);
  }
}

}  // namespace

void build_yard(World& world) {
  Random random(world.seed * 16 + 1);
  GroundPlan plan;
  plan.extent = {{-32, -22}, {32, 22}};
  plan.terrain = uneven(random.next(), 0.06);
  plan.levels = {{{{-32, 14}, {32, 22}}, 0.0, {0, 0}, true, Material::grass},
                 {{{-14, -14.6}, {4, -12}}, 0.03, {0, 0}, true, Material::concrete}};
  world.extent = plan.extent;
  Mesh& mesh = world.objects;
  const auto ground = [&](double x, double y) { return plan.height(x, y); };
  add_building(mesh,
               {{{-31, -21.5}, {between(random, 6, 9), -14.6}}, ground(-12, -14), 2, 3.6, 4.1, Material::brick, true},
               random);
  add_building(
      mesh, {{{12, -21.5}, {31, between(random, -12.5, -11)}}, ground(14, -12), 3, 3.0, 3.1, Material::plaster, false},
      random);
  add_building(mesh,
               {{{-31.5, -6}, {between(random, -25, -23.5), 9}}, ground(-24, 0), 1, 4.2, 3.7, Material::concrete, true},
               random);
  add_building(mesh, {{{23.5, -3}, {28, 2.5}}, ground(24, 0), 1, 2.6, 2.7, Material::wood, false}, random);
  for (const double y : {5.5, 8.4}) {
    const double x = between(random, 14, 21);
    add_container(mesh, at(x, y, ground(x, y), about(random, 0.05)), 6.06);
  }
  add_container(mesh, at(-17, between(random, -9.5, -8), ground(-17, -9), about(random, kQuarter, 0.3)), 6.06);
  for (int i = 0; i < 11; ++i) {
    const double x = between(random, -21, 21), y = i < 5 ? between(random, 9.5, 13) : between(random, -11.5, -5);
    add_crates(mesh, at(x, y, ground(x, y), kTurn * random.uniform()), random);
  }
  add_lorry(mesh, at(between(random, -7, -1), -8.5, ground(-4, -8.5), about(random, 0.15)), random);
  for (int i = 0; i < 3; ++i)
    add_vehicle(world, plan, between(random, 10, 13) + 3.1 * i, -8.3, about(random, kQuarter), random);
  for (int i = 0; i < 7; ++i) {
    const double x = -27 + 8.6 * i + between(random, -1.5, 1.5), y = between(random, 16, 19.5);
    add_tree(mesh, at(x, y, ground(x, y)), random);
  }
  for (int i = 0; i < 6; ++i) {
    const double x = between(random, -28, 28), y = between(random, 14.8, 20);
    add_bush(mesh, at(x, y, ground(x, y)), between(random, 0.5, 0.9), random);
  }
  for (double x = -30; x < 29; x += 6.0)
    add_fence(mesh, {x, 21.4, ground(x, 21.4)}, {x + 5.8, 21.4, ground(x + 5.8, 21.4)});
  for (const double x : {-19.0, 0.5, 19.5}) add_lamp(mesh, at(x, 13.2, ground(x, 13.2), -kQuarter));
  for (int i = 0; i < 4; ++i) add_bollard(mesh, at(-11 + 3.0 * i, -11.4, ground(-11, -11.4)));
  for (int i = 0; i < 3; ++i) add_bin(mesh, at(9.6 + 0.9 * i, -13.0, ground(10, -13), about(random, 0)));
  world.ground = plan.mesh();
  world.route = {{-20, 1}, {-2, 2.5}, {18, 1}};
}

void build_street(World& world) {
  Random random(world.seed * 16 + 2);
  GroundPlan plan;
  const double block_x = 13.0, block_y = 8.5;  // Half the block of houses, its pavement not counted.
  plan.extent = {{-30, -25}, {30, 25}};
  plan.terrain = uneven(random.next(), 0.08);
  const double kerb = 0.12;
  plan.levels = {{{{-30, -25}, {30, -18.5}}, kerb, {0, 0}, true, Material::paving},
                 {{{-30, 18.5}, {30, 25}}, kerb, {0, 0}, true, Material::paving},
                 {{{-30, -25}, {-23, 25}}, kerb, {0, 0}, true, Material::paving},
                 {{{23, -25}, {30, 25}}, kerb, {0, 0}, true, Material::paving},
                 {{{-block_x - 2, -block_y - 2}, {block_x + 2, block_y + 2}}, kerb, {0, 0}, true, Material::paving}};
  world.extent = plan.extent;
  Mesh& mesh = world.objects;
  const auto ground = [&](double x, double y) { return plan.height(x, y); };
  const auto houses = [&](double x0, double y0, double x1, double y1, bool along_x) {
    constexpr std::array kWalls = {Material::plaster, Material::brick, Material::concrete};
    double u = along_x ? x0 : y0;
    const double end = along_x ? x1 : y1;
    while (end - u > 1.0) {
      double length = between(random, 7, 13);
      if (end - u - length < 6.0) length = end - u;
      const double back = between(random, 0, 0.5);
      const Rectangle plot = along_x ? Rectangle{{u, y0 + back}, {u + length, y1 - back}}
                                     : Rectangle{{x0 + back, u}, {x1 - back, u + length}};
      add_building(
          mesh,
          {plot, ground(plot.centre().x(), plot.centre().y()), 2 + static_cast<int>(random.below(3)),
           between(random, 2.8, 3.3), between(random, 2.7, 3.6), kWalls[random.below(3)], random.below(4) == 0},
          random);
      u += length;
    }
  };
  houses(-block_x, -block_y, block_x, 0, true);
  houses(-block_x, 0, block_x, block_y, true);
  houses(-29.9, 20.5, 29.9, 24.9, true);
  houses(-29.9, -24.9, 29.9, -20.5, true);
  houses(-29.9, -20.4, -25.2, 20.4, false);
  houses(25.2, -20.4, 29.9, 20.4, false);
  for (const double side : {-1.0, 1.0}) {
    for (double x = -11; x < 11; x += 6.1) {
      if (random.below(4) != 0)
        add_vehicle(world, plan, x + between(random, -0.4, 0.4), side * 17.3,
                    about(random, side > 0 ? 0 : kTurn / 2, 0.03), random);
      if (random.below(3) == 0)
        add_vehicle(world, plan, x + between(random, -0.4, 0.4), side * 11.7, about(random, 0, 0.03), random);
    }
    for (double y = -7; y < 8; y += 6.2) {
      if (random.below(4) != 0)
        add_vehicle(world, plan, side * 21.8, y + between(random, -0.4, 0.4), about(random, kQuarter, 0.03), random);
    }
    for (double x = -20; x < 21; x += 10.0) {
      const double at_x = x + between(random, -1, 1);
      if (random.below(3) != 0) add_tree(mesh, at(at_x, side * 19.1, ground(at_x, side * 19.1)), random);
      add_lamp(mesh, at(x + 4, side * 10.1, ground(x + 4, side * 10.1), side * kQuarter));
      if (random.below(2) == 0) add_bin(mesh, at(x + 2, side * 20.0, ground(x + 2, side * 20.0), about(random, 0)));
    }
    add_sign(mesh, at(side * 14.6, 10.2, ground(side * 14.6, 10.2), about(random, kQuarter)));
    add_bench(mesh, at(side * 4, -9.3, ground(side * 4, -9.3), -kQuarter));
  }
  world.ground = plan.mesh();
  world.route = {{-19, -14.5}, {19, -14.5}, {19, 14.5}, {-19, 14.5}};
  world.route_is_loop = true;
}

void build_car_park(World& world) {
  Random random(world.seed * 16 + 3);
  GroundPlan plan;
  plan.extent = {{-30, -20}, {30, 20}};
  plan.terrain = uneven(random.next(), 0.05);
  for (const double y : {-3.2, 9.6}) {
    plan.levels.push_back({{{-21, y - 0.6}, {21, y + 0.6}}, 0.15, {0, 0}, true, Material::grass});
  }
  world.extent = plan.extent;
  Mesh& mesh = world.objects;
  const auto ground = [&](double x, double y) { return plan.height(x, y); };
  for (const double y : {-3.2, 9.6}) {
    for (const double side : {-1.0, 1.0}) {
      for (double x = -19.5; x < 20; x += 2.5) {
        if (random.below(10) < 7) {
          add_vehicle(world, plan, x + between(random, -0.15, 0.15), y + side * 3.2,
                      about(random, side * (random.below(3) == 0 ? -kQuarter : kQuarter), 0.05), random);
        }
      }
    }
    for (const double x : {-18.5, -6.0, 6.5, 19.0}) {
      add_tree(mesh, at(x + between(random, -1, 1), y, ground(x, y)), random);
      add_lamp(mesh, at(x + 3.2, y, ground(x + 3.2, y), kQuarter));
    }
  }
  for (double x = -28; x < 20; x += 2.5) {
    if (random.below(10) < 6) add_vehicle(world, plan, x, -16.6, about(random, kQuarter, 0.05), random);
  }
  add_building(
      mesh, {{{-29.5, 16.6}, {between(random, 12, 17), 19.8}}, ground(0, 16), 1, 4.5, 5.0, Material::concrete, false},
      random);
  add_building(mesh,
               {{{23, -1}, {25.6, between(random, 2, 3)}}, ground(24, 0), 1, 2.6, 2.5, Material::bright_paint, false},
               random);
  add_wall(mesh, {-29.6, -19.6}, {29.6, -19.6}, 0, 1.1, 0.24, {Material::concrete, Label::building});
  add_wall(mesh, {29.6, -19.6}, {29.6, 19.6}, 0, 2.2, 0.24, {Material::brick, Label::building});
  for (int i = 0; i < 5; ++i) add_bin(mesh, at(20 + 0.9 * i, 18.4, ground(20, 18.4), about(random, 0)));
  for (int i = 0; i < 6; ++i) add_bollard(mesh, at(22.4, -6 + 1.6 * i, ground(22.4, -6 + 1.6 * i)));
  for (const double y : {-9.0, 13.5}) add_sign(mesh, at(-22.5, y, ground(-22.5, y), about(random, 0)));
  world.ground = plan.mesh();
  world.route = {{-24, -9.5}, {22, -9.5}, {21.5, 3.2}, {-24, 3.2}};
  world.route_is_loop = true;
}

void build_kerbs(World& world) {
  Random random(world.seed * 16 + 4);
  GroundPlan plan;
  plan.extent = {{-22, -18}, {22, 18}};
  plan.material = Material::paving;
  plan.terrain = uneven(random.next(), 0.04);
  const auto island = [&](double x, double y, double w, double h, double up, Material material) {
    plan.levels.push_back({{{x, y}, {x + w, y + h}}, up, {0, 0}, true, material});
  };
  island(-15, -10, between(random, 7, 9), between(random, 3, 4), 0.12, Material::grass);
  island(3, -11, between(random, 8, 10), between(random, 3, 5), 0.05, Material::concrete);
  island(-14, 5, between(random, 6, 8), between(random, 4, 5), 0.05, Material::concrete);
  island(4, 6, between(random, 9, 11), between(random, 3, 4), 0.12, Material::grass);
  // Dropped kerbs: ramps that a robot can take onto the islands of 12 cm.
  plan.levels.push_back({{{-12, -10}, {-10.5, -8.8}}, 0.0, {0, 0.1}, true, Material::paving});
  plan.levels.push_back({{{8, 6}, {9.5, 7.2}}, 0.0, {0, 0.1}, true, Material::paving});
  world.extent = plan.extent;
  Mesh& mesh = world.objects;
  const auto ground = [&](double x, double y) { return plan.height(x, y); };
  add_building(mesh, {{{-21.8, 14}, {21.8, 17.8}}, ground(0, 14), 3, 3.1, 3.3, Material::brick, false}, random);
  add_building(
      mesh,
      {{{-21.8, -17.8}, {between(random, -4, 4), -14.5}}, ground(-10, -15), 2, 3.3, 3.9, Material::plaster, false},
      random);
  add_building(mesh,
               {{{18, -12}, {21.8, between(random, -1, 4)}}, ground(18, -5), 2, 3.0, 2.9, Material::concrete, true},
               random);
  add_wall(mesh, {-21.6, -14}, {-21.6, 13.5}, ground(-21.6, 0), 1.8, 0.3, {Material::brick, Label::building});
  for (const Vector2d& p : {Vector2d(-9, -8), Vector2d(-11, 7), Vector2d(12, 8.2)})
    add_tree(mesh, at(p.x(), p.y(), ground(p.x(), p.y())), random);
  for (const Vector2d& p : {Vector2d(6, -9), Vector2d(-13.4, 9), Vector2d(5, 8.8)})
    add_lamp(mesh, at(p.x(), p.y(), ground(p.x(), p.y()), kTurn * random.uniform()));
  for (int i = 0; i < 4; ++i) add_bench(mesh, at(-9 + 5.0 * i, 13.0, ground(-9 + 5.0 * i, 13.0), -kQuarter));
  for (int i = 0; i < 5; ++i) add_bollard(mesh, at(2.2, -10 + 1.3 * i, ground(2.2, -10 + 1.3 * i)));
  add_vehicle(world, plan, between(random, 9, 13), -13.5, about(random, 0), random);
  world.ground = plan.mesh();
  world.route = {{-17, 0.5}, {0, -1}, {16, 2}};
}

}  // namespace scanway::simulator
