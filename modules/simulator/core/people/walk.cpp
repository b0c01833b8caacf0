#include "modules/simulator/core/people/walk.h"

#include <algorithm>
#include <cmath>

#include "common/math/repeatable.h"
#include "modules/simulator/core/world/things.h"

namespace scanway::simulator {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kShoulders_m = 0.35;  // To each side, kept free.
constexpr double kSamples_m = 0.25;
constexpr double kHighestStep_m = 0.2;
constexpr double kNearest_m = 1.0;
constexpr double kLeast_m = 2.0, kMost_m = 8.0;
constexpr int kTries = 400;

/// Heights of the ground along the way, seen from breast height; empty where there is none or a step is too high.
std::vector<double> ground_along(const RayCaster& world, const Vector2d& from, const Vector2d& to, double about_z) {
  const int samples = std::max(2, static_cast<int>(std::ceil((to - from).norm() / kSamples_m)) + 1);
  std::vector<double> heights;
  double last = about_z;
  for (int i = 0; i < samples; ++i) {
    const Vector2d at = from + (to - from) * i / (samples - 1);
    const auto hit = world.cast({at.x(), at.y(), last + 1.2}, -Vector3d::UnitZ(), 2.5);
    if (!hit || hit->surface.label != Label::ground) return {};
    const double z = last + 1.2 - hit->range_m;
    if (i > 0 && std::fabs(z - last) > kHighestStep_m) return {};
    heights.push_back(last = z);
  }
  return heights;
}

/// Whether rays at knee, hip and head, and a little to both sides, meet nothing.
bool is_clear(const RayCaster& world, const Vector2d& from, const Vector2d& to, double from_z, double to_z) {
  const Vector2d ahead = (to - from).normalized(), left(-ahead.y(), ahead.x());
  for (const double aside : {-kShoulders_m, 0.0, kShoulders_m}) {
    for (const double height : {0.35, 0.95, 1.75}) {
      const Vector2d a = from + aside * left, b = to + aside * left;
      const Vector3d begin(a.x(), a.y(), from_z + height), end(b.x(), b.y(), to_z + height);
      const Vector3d way = end - begin;
      if (world.cast(begin, way.normalized(), way.norm() + 0.3)) return false;
    }
  }
  return true;
}

double distance_to_way(const Vector2d& p, const Vector2d& from, const Vector2d& to) {
  const Vector2d way = to - from;
  const double share = std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (from + share * way - p).norm();
}

}  // namespace

std::optional<Walk> Walk::find(const RayCaster& world, const Vector3d& place, Random& random) {
  const Vector2d centre = place.head<2>();
  const auto anywhere = [&] {
    const double r = kReach_m * std::sqrt(random.uniform()), angle = 2.0 * repeatable::kPi * random.uniform();
    return Vector2d(centre.x() + r * repeatable::cos(angle), centre.y() + r * repeatable::sin(angle));
  };
  for (int i = 0; i < kTries; ++i) {
    const Vector2d from = anywhere(), to = anywhere();
    const double length = (to - from).norm();
    if (length < kLeast_m || length > kMost_m || distance_to_way(centre, from, to) < kNearest_m) continue;
    const auto ground = ground_along(world, from, to, place.z());
    if (ground.empty() || !is_clear(world, from, to, ground.front(), ground.back())) continue;
    return Walk(from, to, ground, random);
  }
  return std::nullopt;
}

Walk::Walk(const Vector2d& from, const Vector2d& to, std::vector<double> ground, Random& random)
    : from_(from),
      ahead_((to - from).normalized()),
      length_m_((to - from).norm()),
      speed_m_s_(between(random, 0.8, 1.5)),
      start_m_(between(random, 0.0, 2 * length_m_)),
      ground_(std::move(ground)) {}

Pose Walk::X_world_person(double time_us) const {
  const double walked = start_m_ + speed_m_s_ * time_us * 1e-6;
  const double lap = walked - 2 * length_m_ * std::floor(walked / (2 * length_m_));
  const bool back = lap > length_m_;
  const double along = back ? 2 * length_m_ - lap : lap;
  const double sample = along / length_m_ * static_cast<double>(ground_.size() - 1);
  const auto left = std::min(static_cast<std::size_t>(sample), ground_.size() - 2);
  const double share = sample - static_cast<double>(left);
  const Vector2d at = from_ + along * ahead_, facing = back ? Vector2d(-ahead_) : ahead_;
  Pose X = Pose::Identity();
  X.linear().col(0) = Vector3d(facing.x(), facing.y(), 0.0);
  X.linear().col(1) = Vector3d(-facing.y(), facing.x(), 0.0);
  X.translation() = Vector3d(at.x(), at.y(), ground_[left] * (1 - share) + ground_[left + 1] * share);
  return X;
}

}  // namespace scanway::simulator
