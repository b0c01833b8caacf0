#include "common/math/repeatable.h"
#include "modules/simulator/core/world/builders.h"
#include "modules/simulator/core/world/building.h"
#include "modules/simulator/core/world/things.h"

/// Worlds under a roof, and what is left of one: hall, corridor, rubble.
namespace scanway::simulator {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Four walls and a roof around the floor `plan`.
void add_shell(Mesh& mesh, const Rectangle& plan, double height, Material wall) {
  const auto& [low, high] = plan;
  const Surface side{wall, Label::building}, roof{Material::steel, Label::roof};
  const double t = 0.3;
  add_block(mesh, {low.x() - t, low.y() - t, -0.6}, {high.x() + t, low.y(), height}, side);
  add_block(mesh, {low.x() - t, high.y(), -0.6}, {high.x() + t, high.y() + t, height}, side);
  add_block(mesh, {low.x() - t, low.y(), -0.6}, {low.x(), high.y(), height}, side);
  add_block(mesh, {high.x(), low.y(), -0.6}, {high.x() + t, high.y(), height}, side);
  add_block(mesh, {low.x() - t, low.y() - t, height}, {high.x() + t, high.y() + t, height + 0.3}, roof);
}

void add_truss(Mesh& mesh, double x, double y0, double y1, double height) {
  const Surface steel{Material::steel, Label::roof};
  add_block(mesh, {x - 0.1, y0, height - 0.2}, {x + 0.1, y1, height}, steel);
  add_block(mesh, {x - 0.1, y0, height - 1.0}, {x + 0.1, y1, height - 0.85}, steel);
  const int fields = static_cast<int>((y1 - y0) / 1.5);
  for (int i = 0; i < fields; ++i) {
    const Isometry3d X = at(x, y0 + (i + 0.5) * (y1 - y0) / fields, height - 0.55, kQuarter);
    add_box(mesh, X, {0.08, 0.08, 0.8}, steel);
  }
}

}  // namespace

void build_hall(World& world) {
  Random random(world.seed * 16 + 10);
  GroundPlan plan;
  plan.extent = {{-24, -15}, {24, 15}};
  plan.material = Material::concrete;
  world.extent = plan.extent;
  Mesh& mesh = world.objects;
  const double height = between(random, 6.2, 7.4);
  add_shell(mesh, plan.extent, height, Material::plaster);
  const Surface concrete{Material::concrete, Label::pillar};
  for (double x = -18; x < 19; x += 6) {
    for (const double y : {-5.0, 5.0})
      add_block(mesh, {x - 0.22, y - 0.22, -0.1}, {x + 0.22, y + 0.22, height - 0.9}, concrete);
    for (const double side : {-14.85, 14.85})
      add_block(mesh, {x - 0.25, side - 0.15, -0.1}, {x + 0.25, side + 0.15, height}, concrete);
    add_truss(mesh, x, -15, 15, height);
  }
  for (const double x : {-9.0, 9.0}) {  // Gates, and the frames round them.
    add_block(mesh, {x - 1.8, 14.92, -0.1}, {x + 1.8, 15.05, 3.8}, {Material::steel, Label::building});
    for (const double edge : {-1.9, 1.9})
      add_block(mesh, {x + edge - 0.1, 14.75, -0.1}, {x + edge + 0.1, 15.05, 3.9}, {Material::steel, Label::building});
  }
  add_block(mesh, {between(random, -23, -21), -14.98, -0.1},
            {between(random, -17, -15), between(random, -11.5, -10.5), 3.0}, {Material::plaster, Label::building});
  for (int i = 0; i < 3; ++i) add_shelf(mesh, at(between(random, 9, 11) + 0.4 * i, -13.6 + 3.1 * i, 0), 8.1, random);
  for (int i = 0; i < 5; ++i)
    add_machine(mesh,
                at(-12.5 + 6.0 * i + between(random, -1, 1), between(random, 8.5, 11.5), 0, between(random, -0.2, 0.2)),
                random);
  for (int i = 0; i < 3; ++i)
    add_machine(mesh, at(-11 + 5.5 * i, between(random, -11.5, -8.5), 0, kQuarter + between(random, -0.2, 0.2)),
                random);
  for (int i = 0; i < 9; ++i) {
    add_crates(
        mesh,
        at(between(random, -22, 22), (i % 2 == 0 ? 1 : -1) * between(random, 3, 6.8), 0, kTurn * random.uniform()),
        random);
  }
  for (const double y : {-14.4, 13.9})
    add_block(mesh, {-23.9, y, 4.6}, {23.9, y + 0.35, 4.95}, {Material::steel, Label::building});  // Ducts.
  for (int i = 0; i < 4; ++i) add_bollard(mesh, at(-11.4 + 1.6 * i, 13.6, 0));
  world.ground = plan.mesh();
  world.route = {{-21, 0}, {0, 0.6}, {21, -0.3}};
}

void build_corridor(World& world) {
  Random random(world.seed * 16 + 11);
  GroundPlan plan;
  const double half_width = between(random, 1.1, 1.5);
  plan.extent = {{-100, -half_width}, {100, half_width}};
  plan.material = Material::concrete;
  plan.spacing_m = 5.0;
  world.extent = plan.extent;
  Mesh& mesh = world.objects;
  add_shell(mesh, plan.extent, between(random, 2.6, 3.0), Material::plaster);
  const Surface steel{Material::steel, Label::building}, wood{Material::wood, Label::building};
  // A skirting, a handrail and a duct, all from end to end.
  add_block(mesh, {-100, half_width - 0.03, -0.05}, {100, half_width + 0.05, 0.12}, wood);
  add_block(mesh, {-100, -half_width - 0.05, -0.05}, {100, -half_width + 0.03, 0.12}, wood);
  add_block(mesh, {-100, half_width - 0.1, 0.95}, {100, half_width - 0.05, 1.0}, steel);
  add_block(mesh, {-100, -half_width + 0.02, 2.15}, {100, -half_width + 0.3, 2.45}, steel);
  world.ground = plan.mesh();
  world.route = {{-18, 0}, {18, 0}};
}

void build_rubble(World& world) {
  Random random(world.seed * 16 + 12);
  GroundPlan plan;
  plan.extent = {{-22, -17}, {22, 17}};
  plan.material = Material::soil;
  plan.terrain = uneven(random.next(), 0.08);
  world.extent = plan.extent;
  Mesh& mesh = world.objects;
  const auto ground = [&](double x, double y) { return plan.height(x, y); };
  const Surface concrete{Material::concrete, Label::debris}, brick{Material::brick, Label::debris};
  // What still stands: outer walls of uneven height.
  for (double x = -21; x < 20.5; x += 1.4) {
    if (random.below(9) != 0)
      add_wall(mesh, {x, 15.6}, {x + 1.4, 15.6}, ground(x, 15.6), between(random, 1.2, 5.5), 0.4,
               {Material::brick, Label::building});
    if (random.below(3) == 0)
      add_wall(mesh, {x, -15.4}, {x + 1.4, -15.4}, ground(x, -15.4), between(random, 0.4, 3.5), 0.4,
               {Material::brick, Label::building});
  }
  for (double y = -15; y < 15; y += 1.4) {
    if (random.below(4) != 0)
      add_wall(mesh, {-20.8, y}, {-20.8, y + 1.4}, ground(-20.8, y), between(random, 0.8, 6), 0.4,
               {Material::brick, Label::building});
  }
  add_building(mesh, {{{15, 4}, {21.5, 13}}, ground(15, 8), 2, 3.0, 3.1, Material::concrete, false}, random);
  // Things lie everywhere but on a way of some metres along the route.
  const auto somewhere = [&](double clear) {
    for (;;) {
      const double x = between(random, -20, 20), y = between(random, -14.5, 14.5);
      const bool on_way = y > -clear && y<clear + 1.2, in_house = x> 13 && y > 2.5;
      if (!on_way && !in_house) return Eigen::Vector2d(x, y);
    }
  };
  for (int i = 0; i < 26; ++i) {  // Slabs: each rests on one edge.
    const Eigen::Vector2d p = somewhere(2.4);
    const double tilt = between(random, 0.05, 0.6), width = between(random, 1.2, 3.2);
    const double lift = 0.5 * width * repeatable::sin(tilt) * 0.8;
    const double heading = kTurn * random.uniform();
    add_box(mesh, tilted_at(p.x(), p.y(), ground(p.x(), p.y()) + lift, heading, tilt, heading),
            {between(random, 1.5, 4.0), width, 0.2}, concrete);
  }
  for (int i = 0; i < 22; ++i) {  // Beams.
    const Eigen::Vector2d p = somewhere(2.2);
    const double heading = kTurn * random.uniform(), tilt = between(random, 0.0, 0.35),
                 length = between(random, 2.0, 5.0);
    add_box(mesh,
            tilted_at(p.x(), p.y(), ground(p.x(), p.y()) + 0.1 + 0.4 * length * repeatable::sin(tilt), heading, tilt,
                      heading + kQuarter),
            {length, 0.22, 0.28}, {random.below(3) == 0 ? Material::steel : Material::concrete, Label::debris});
  }
  for (int i = 0; i < 420; ++i) {  // Bricks and lumps; some small enough to drive over, and some beside the way.
    const double side = i % 2 == 0 ? between(random, -1.7, -0.4) : between(random, 1.5, 2.6);
    const Eigen::Vector2d p = i < 40 ? Eigen::Vector2d(between(random, -19, 12), side) : somewhere(1.7);
    const double size = i % 3 == 0 ? between(random, 0.3, 0.9) : between(random, 0.06, 0.3);
    const double body = i < 40 ? between(random, 0.06, 0.22) : size;
    add_box(mesh,
            tilted_at(p.x(), p.y(), ground(p.x(), p.y()) + 0.2 * body, kTurn * random.uniform(),
                      between(random, 0, 0.7), kTurn * random.uniform()),
            {body * between(random, 0.8, 1.8), body, body * between(random, 0.5, 1.0)}, i % 2 == 0 ? brick : concrete);
  }
  world.ground = plan.mesh();
  world.route = {{-18, 0.5}, {-4, 0.8}, {10, 0.3}};
}

}  // namespace scanway::simulator
