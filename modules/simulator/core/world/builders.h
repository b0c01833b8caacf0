#pragma once

#include "common/math/repeatable.h"
#include "modules/simulator/core/world/world.h"

/// Each builds one kind of world; make_world() has given it its name and seed.
namespace scanway::simulator {

constexpr double kTurn = 2.0 * repeatable::kPi;
constexpr double kQuarter = repeatable::kPi / 2;

void build_flat(World& world);
void build_slope(World& world);
void build_yard(World& world);
void build_street(World& world);
void build_hall(World& world);
void build_car_park(World& world);
void build_rubble(World& world);
void build_corridor(World& world);
void build_field(World& world);
void build_ramp(World& world);
void build_trench(World& world);
void build_kerbs(World& world);

}  // namespace scanway::simulator
