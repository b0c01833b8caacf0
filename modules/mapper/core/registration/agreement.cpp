#include "modules/mapper/core/registration/agreement.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_invoke.h>

namespace scanway::registration {
namespace {

constexpr float kOverlapDistance = 0.3f;
constexpr float kSurfaceDistance = 0.6f;  // between the centres of like surfaces
constexpr float kPlaneDistance = 0.12f;   // of one centre from the other's plane
constexpr float kTightDistance = 0.05f;   // the same, of surfaces that are registered to the centimetre
constexpr float kMinNormalCosine = 0.9f;
constexpr double kFacing = 0.25;           // squared cosine of 60 degrees
constexpr std::size_t kGapSamples = 6000;  // points a side

/// One direction: `from` seen by `to`.
struct OneWay {
  double overlap = 0.0, conflict = 0.0, surface_fit = 0.0;
};

bool in_view(RangeImage::Sight sight) {
  return sight == RangeImage::Sight::free || sight == RangeImage::Sight::surface;
}

struct View {
  const PreparedScan::Data& from;
  const PreparedScan::Data& to;
  Eigen::Matrix3f R;
  Eigen::Vector3f t;

  OneWay assess(std::size_t samples) const {
    OneWay result;
    const Points& points = from.fine.points();
    const std::size_t stride = std::max<std::size_t>(1, points.size() / samples);
    double total = 0.0, near = 0.0, seen = 0.0, free = 0.0;
    for (std::size_t i = stride / 2; i < points.size(); i += stride) {
      const Eigen::Vector3f p = R * points[i] + t;
      const bool matched = to.fine.any_within(p, kOverlapDistance);
      const RangeImage::Sight sight = matched ? RangeImage::Sight::surface : to.image.look(p);
      total += 1.0;
      near += matched ? 1.0 : 0.0;
      seen += in_view(sight) ? 1.0 : 0.0;
      free += sight == RangeImage::Sight::free ? 1.0 : 0.0;
    }
    result.overlap = total > 0.0 ? near / total : 0.0;
    result.conflict = seen > 0.0 ? free / seen : 1.0;
    result.surface_fit = surface_fit(samples);
    return result;
  }

  double surface_fit(std::size_t samples) const {
    const Surfaces& surfaces = from.surfaces_for(samples);
    double met = 0.0, visible = 0.0;
    for (std::size_t i = 0; i < surfaces.count(); ++i) {
      const Eigen::Vector3f p = R * surfaces.centre[i] + t, n = R * surfaces.normal[i];
      const bool fits = meets_like_surface(p, n, kPlaneDistance);
      if (fits) met += surfaces.weight[i];
      if (fits || in_view(to.image.look(p))) visible += surfaces.weight[i];
    }
    return visible > 0.0 ? met / visible : 0.0;
  }

  Hold hold(const Eigen::Matrix3f& axes) const {
    Eigen::Vector3d met = Eigen::Vector3d::Zero(), visible = Eigen::Vector3d::Constant(1e-9);
    Hold result;
    for (std::size_t i = 0; i < from.surfaces.count(); ++i) {
      const Eigen::Vector3f p = R * from.surfaces.centre[i] + t, n = R * from.surfaces.normal[i];
      const Eigen::Vector3d hold = (axes.transpose() * n).cwiseAbs2().cast<double>();
      if (!in_view(to.image.look(p))) continue;
      visible += hold;
      if (!meets_like_surface(p, n, kTightDistance)) continue;
      met += hold;
      result.facing += (hold.array() > kFacing).cast<double>().matrix();
    }
    result.fit = met.cwiseQuotient(visible).minCoeff();
    return result;
  }

  double gap() const {
    const Points& points = from.fine.points();
    const std::size_t stride = std::max<std::size_t>(1, points.size() / kGapSamples);
    double sum = 0.0, count = 0.0;
    for (std::size_t i = stride / 2; i < points.size(); i += stride, count += 1.0) {
      sum += std::sqrt(to.fine.nearest(R * points[i] + t, kOverlapDistance).squared_distance);
    }
    return count > 0.0 ? sum / count : 0.0;
  }

  bool meets_like_surface(const Eigen::Vector3f& p, const Eigen::Vector3f& n, float plane_distance) const {
    const CellGrid& grid = to.surface_grid;
    return grid.any_within(p, kSurfaceDistance, [&](std::uint32_t position) {
      const Eigen::Vector3f& normal = to.surfaces.normal[grid.original()[position]];
      return n.dot(normal) > kMinNormalCosine && std::fabs(normal.dot(p - grid.points()[position])) < plane_distance;
    });
  }
};

View view(const PreparedScan::Data& from, const PreparedScan::Data& to, const Pose& T_to_from) {
  return {from, to, T_to_from.linear().cast<float>(), T_to_from.translation().cast<float>()};
}

}  // namespace

Agreement assess(const PreparedScan::Data& source, const PreparedScan::Data& target, const Pose& T_target_source,
                 std::size_t samples) {
  OneWay there, back;
  tbb::parallel_invoke([&] { there = view(source, target, T_target_source).assess(samples); },
                       [&] { back = view(target, source, T_target_source.inverse()).assess(samples); });
  Agreement agreement;
  agreement.overlap = there.overlap;
  agreement.overlap_back = back.overlap;
  agreement.conflict = std::max(there.conflict, back.conflict);
  agreement.surface_fit = std::min(there.surface_fit, back.surface_fit);
  return agreement;
}

Hold hold_of(const PreparedScan::Data& source, const PreparedScan::Data& target, const Pose& T_target_source,
             const Eigen::Matrix3d& axes) {
  const Pose T_source_target = T_target_source.inverse();
  const Eigen::Matrix3f axes_there = axes.cast<float>(), axes_back = (T_source_target.linear() * axes).cast<float>();
  Hold there, back;
  tbb::parallel_invoke([&] { there = view(source, target, T_target_source).hold(axes_there); },
                       [&] { back = view(target, source, T_source_target).hold(axes_back); });
  return {std::min(there.fit, back.fit), there.facing.cwiseMin(back.facing)};
}

double mean_gap(const PreparedScan::Data& source, const PreparedScan::Data& target, const Pose& T_target_source) {
  double there = 0.0, back = 0.0;
  tbb::parallel_invoke([&] { there = view(source, target, T_target_source).gap(); },
                       [&] { back = view(target, source, T_target_source.inverse()).gap(); });
  return 0.5 * (there + back);
}

}  // namespace scanway::registration
