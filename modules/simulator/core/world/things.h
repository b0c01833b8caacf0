#pragma once

#include <Eigen/Geometry>

#include "common/random/random.h"
#include "modules/simulator/core/world/mesh.h"

/// Things that stand about. X is the thing's place: its origin on the ground, x ahead, z up; it reaches a little below
/// the ground, so that none hovers on uneven ground. What the seed decides comes from `random`.
namespace scanway::simulator {

/// On the ground at (x, y, z), turned by `heading` about z.
Eigen::Isometry3d at(double x, double y, double z, double heading = 0.0);
/// The same, tilted by `tilt` radians about a level axis that points along `tilt_axis_heading`.
Eigen::Isometry3d tilted_at(double x, double y, double z, double heading, double tilt, double tilt_axis_heading);

double between(Random& random, double low, double high);

void add_car(Mesh& mesh, const Eigen::Isometry3d& X, Random& random);
void add_van(Mesh& mesh, const Eigen::Isometry3d& X, Random& random);
void add_lorry(Mesh& mesh, const Eigen::Isometry3d& X, Random& random);

void add_tree(Mesh& mesh, const Eigen::Isometry3d& X, Random& random);
void add_bush(Mesh& mesh, const Eigen::Isometry3d& X, double radius, Random& random);

void add_lamp(Mesh& mesh, const Eigen::Isometry3d& X);
void add_sign(Mesh& mesh, const Eigen::Isometry3d& X);
void add_bollard(Mesh& mesh, const Eigen::Isometry3d& X);
void add_bin(Mesh& mesh, const Eigen::Isometry3d& X);
void add_bench(Mesh& mesh, const Eigen::Isometry3d& X);
void add_crates(Mesh& mesh, const Eigen::Isometry3d& X, Random& random);
void add_container(Mesh& mesh, const Eigen::Isometry3d& X, double length);
void add_machine(Mesh& mesh, const Eigen::Isometry3d& X, Random& random);
void add_shelf(Mesh& mesh, const Eigen::Isometry3d& X, double length, Random& random);
/// Posts, two rails and boards from a to b, both on the ground.
void add_fence(Mesh& mesh, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace scanway::simulator
