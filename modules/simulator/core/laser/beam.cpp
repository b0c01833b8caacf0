#include "modules/simulator/core/laser/beam.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/math/repeatable.h"

namespace scanway::simulator {

using Eigen::Vector3d;

namespace {

// Surfaces nearer to each other than this along a beam come back as one echo: half the length of the pulse.
constexpr double kOneEcho_m = 0.5;
constexpr double kPowerSpread = 0.15;  // Of the threshold, from beam to beam.
constexpr double kBodyReach_m = 3.0;
constexpr std::uint16_t kFirstRangeCount = 16;  // Smaller counts are marks.
constexpr double kLastRangeCount = 65000;

/// One ray of a cone: its share of the beam's light.
struct Sample {
  std::optional<Hit> hit;
  double weight = 0.0;
  double power = 0.0;
};

/// Four rays at `radius` (of the cone's half angle) about the axis, `turned` by an eighth of a turn or not.
RayCaster::Four ring(const Vector3d& axis, const Vector3d& u, const Vector3d& v, double radius, bool turned) {
  const Vector3d a = radius * (turned ? Vector3d(u + v) * std::sqrt(0.5) : u);
  const Vector3d b = radius * (turned ? Vector3d(v - u) * std::sqrt(0.5) : v);
  return {(axis + a).normalized(), (axis + b).normalized(), (axis - a).normalized(), (axis - b).normalized()};
}

/// Which part of the light that falls on the surface at this angle comes back, as for a white sheet.
double returned(const Optics& optics, double cosine) {
  if (optics.mirrors) {
    const double c2 = cosine * cosine, c4 = c2 * c2, c8 = c4 * c4, c16 = c8 * c8;
    return 5.0 * optics.reflectivity * c16 * c16 * c8;
  }
  return optics.reflectivity * ((1.0 - optics.roughness) * cosine + optics.roughness * std::sqrt(cosine));
}

double power_of(const Hit& hit, const Vector3d& direction) {
  const double cosine = std::min(1.0, std::fabs(hit.normal.dot(direction)));
  return returned(optics_of(hit.surface.material), cosine) / std::max(0.01, hit.range_m * hit.range_m);
}

bool all_on_one_plane(const RayCaster::FourHits& hits) {
  return std::all_of(hits.begin(), hits.end(), [&](const auto& hit) { return hit && hit->same_plane(*hits[0]); });
}

bool all_miss(const RayCaster::FourHits& hits) {
  return std::none_of(hits.begin(), hits.end(), [](const auto& hit) { return hit.has_value(); });
}

}  // namespace

/// What comes back at about one time.
struct BeamModel::Echo {
  double range_m = 0.0;
  double power = 0.0;
  Surface surface;
};

BeamModel::BeamModel(const Robot::Laser& laser, const RayCaster& world, const RayCaster& body, const People& people,
                     double window)
    : laser_(laser),
      world_(world),
      body_(body),
      people_(people),
      window_(window),
      range_scale_m_(laser.max_range_m <= 65.0 ? 0.001 : 0.002) {}

RayCaster::FourHits BeamModel::cast(const Vector3d& origin, const RayCaster::Four& directions, double time_us) const {
  const double reach_m = laser_.max_range_m + 1.0;
  RayCaster::FourHits on_body = body_.cast(origin, directions, kBodyReach_m);
  RayCaster::FourHits on_world = world_.cast(origin, directions, reach_m);
  people_.stand_before(on_world, origin, directions, reach_m, time_us);
  if (all_miss(on_body)) return on_world;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!on_body[i] || (on_world[i] && on_world[i]->range_m < on_body[i]->range_m)) on_body[i] = on_world[i];
  }
  return on_body;
}

BeamReading BeamModel::reading_of(const Echo& echo, Random& random) const {
  const Optics& optics = optics_of(echo.surface.material);
  double range = echo.range_m + laser_.range_sigma_m * random.normal();
  if (optics.relief_m > 0.0) range += optics.relief_m * random.normal();
  const double count = std::floor(range / range_scale_m_ + 0.5);
  if (range > laser_.max_range_m || count < kFirstRangeCount || count > kLastRangeCount) return {};
  const double white = std::min(2.0, window_ * echo.power * echo.range_m * echo.range_m);
  const double rssi = 35.0 + 170.0 * std::sqrt(white) - 0.8 * echo.range_m + 6.0 * (random.uniform() - 0.5);
  return {static_cast<std::uint16_t>(count), static_cast<std::uint8_t>(std::clamp(std::floor(rssi + 0.5), 1.0, 255.0)),
          echo.surface.label};
}

BeamReading BeamModel::read(const Eigen::Isometry3d& X_world_laser, double angle, double time_us, Random random) const {
  const double cosine = repeatable::cos(angle), sine = repeatable::sin(angle);
  const Vector3d axis = X_world_laser.linear() * Vector3d(cosine, sine, 0.0);
  const double half_angle = laser_.divergence / 2;
  const Vector3d u = half_angle * (X_world_laser.linear() * Vector3d(-sine, cosine, 0.0));
  const Vector3d v = half_angle * X_world_laser.linear().col(2);
  const Vector3d origin = X_world_laser.translation();
  const double least_power = kLeastPower / window_ * (1.0 + kPowerSpread * (2.0 * random.uniform() - 1.0));

  const RayCaster::Four middle = ring(axis, u, v, 0.6, true);
  const RayCaster::FourHits first = cast(origin, middle, time_us);
  if (all_on_one_plane(first)) {
    Hit hit = *first[0];
    hit.range_m = (hit.offset_m - hit.normal.dot(origin)) / hit.normal.dot(axis);
    const Echo echo{hit.range_m, power_of(hit, axis), hit.surface};
    return echo.power >= least_power ? reading_of(echo, random) : BeamReading{};
  }
  if (all_miss(first)) return {};

  // The weights are those of a Gaussian beam whose power falls to 1/e^2 at the half angle.
  std::array<Sample, 12> samples;
  const auto take = [&](std::size_t from, const RayCaster::Four& directions, const RayCaster::FourHits& hits,
                        double weight) {
    for (std::size_t i = 0; i < 4; ++i) {
      samples[from + i] = {hits[i], weight, hits[i] ? weight * power_of(*hits[i], directions[i]) : 0.0};
    }
  };
  const RayCaster::Four inner = ring(axis, u, v, 0.25, false), outer = ring(axis, u, v, 0.95, false);
  take(0, inner, cast(origin, inner, time_us), 0.120);
  take(4, middle, first, 0.099);
  take(8, outer, cast(origin, outer, time_us), 0.031);
  std::stable_sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return (a.hit ? a.hit->range_m : 1e9) < (b.hit ? b.hit->range_m : 1e9);
  });
  for (std::size_t i = 0; i < samples.size() && samples[i].hit;) {
    Echo echo;
    double strongest = -1.0, last = samples[i].hit->range_m;
    for (; i < samples.size() && samples[i].hit && samples[i].hit->range_m - last <= kOneEcho_m; ++i) {
      last = samples[i].hit->range_m;
      echo.range_m += samples[i].power * last;
      echo.power += samples[i].power;
      if (samples[i].power > strongest) {
        strongest = samples[i].power;
        echo.surface = samples[i].hit->surface;
      }
    }
    if (echo.power < least_power) continue;
    echo.range_m /= echo.power;
    return reading_of(echo, random);
  }
  return {};
}

}  // namespace scanway::simulator
