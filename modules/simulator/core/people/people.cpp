#include "modules/simulator/core/people/people.h"

#include <array>
#include <cmath>

#include "modules/simulator/core/world/mesh.h"

namespace scanway::simulator {
namespace {

using Eigen::Vector3d;

constexpr double kGirth_m = 0.6;  // Farther than this from its axis nobody reaches.
constexpr double kHeight_m = 1.8;

Mesh person() {
  const Surface clothes{Material::wood, Label::person}, skin{Material::plaster, Label::person};
  Mesh mesh;
  for (const double side : {-0.1, 0.1}) {
    Pose X_leg = Pose::Identity();
    X_leg.translation() = Vector3d(side, side, 0.0);  // In mid-stride.
    add_cylinder(mesh, X_leg, 0.08, 0.0, 0.85, clothes, 8);
    Pose X_arm = Pose::Identity();
    X_arm.translation() = Vector3d(-side, 2.7 * side, 0.0);
    add_cylinder(mesh, X_arm, 0.05, 0.75, 1.4, clothes, 8);
  }
  add_cylinder(mesh, Pose::Identity(), 0.19, 0.8, 1.45, clothes, 12);
  add_cylinder(mesh, Pose::Identity(), 0.1, 1.5, kHeight_m, skin, 10);
  return mesh;
}

/// Whether the ray comes near the upright axis at `foot`.
bool comes_near(const Vector3d& foot, const Vector3d& origin, const Vector3d& direction) {
  const double x = foot.x() - origin.x(), y = foot.y() - origin.y();
  const double flat = direction.x() * direction.x() + direction.y() * direction.y();
  const double along = x * direction.x() + y * direction.y(), across = x * direction.y() - y * direction.x();
  const bool inside = x * x + y * y < kGirth_m * kGirth_m;
  return inside || (along > 0.0 && across * across < kGirth_m * kGirth_m * flat);
}

}  // namespace

People::People(const RayCaster& world, const Vector3d& place, int count, std::uint64_t seed) {
  for (int i = 0; i < count; ++i) {
    Random random(Random(seed ^ 0x70656F706C65).next() + static_cast<std::uint64_t>(i));
    if (auto walk = Walk::find(world, place, random)) walks_.push_back(std::move(*walk));
  }
  const Mesh mesh = person();
  if (!walks_.empty()) body_ = std::make_shared<const RayCaster>(std::array{&mesh});
}

void People::stand_before(RayCaster::FourHits& hits, const Vector3d& origin, const RayCaster::Four& directions,
                          double max_range_m, double time_us) const {
  for (const Walk& walk : walks_) {
    const Pose X_world_person = walk.X_world_person(time_us);
    if (!comes_near(X_world_person.translation(), origin, directions[0])) continue;
    const Pose X_person_world = X_world_person.inverse();
    RayCaster::Four turned;
    for (std::size_t i = 0; i < 4; ++i) turned[i] = X_person_world.linear() * directions[i];
    const RayCaster::FourHits on_person = body_->cast(X_person_world * origin, turned, max_range_m);
    for (std::size_t i = 0; i < 4; ++i) {
      if (!on_person[i] || (hits[i] && hits[i]->range_m < on_person[i]->range_m)) continue;
      Hit hit = *on_person[i];
      hit.normal = X_world_person.linear() * hit.normal;
      hit.offset_m += hit.normal.dot(X_world_person.translation());
      hits[i] = hit;
    }
  }
}

}  // namespace scanway::simulator
