#include "modules/simulator/core/ray/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <stdexcept>
#include <utility>

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

namespace scanway::simulator {
namespace {

using Eigen::Vector3d;

// One instruction set for all CPUs: with AVX2 Embree would use fused multiply-adds, and answer otherwise at edges.
constexpr const char* kDeviceSettings = "isa=sse4.2";
// Embree's ranges rest on the CPU's approximate reciprocal, which differs from make to make. Which of the surfaces that
// are nearest within this is the nearest is decided in double.
constexpr double kTie_m = 1e-4;
constexpr double kTieShare = 1e-5;  // Of the range.
// Farther off Embree's own range than this, the plane's is of no use: the ray all but lies in it.
constexpr double kRangeTrust_m = 0.02;
// Of one plane are surfaces whose normals and offsets differ by no more than what floats make of coordinates.
constexpr double kSameNormal = 1e-5;
constexpr double kSameOffset_m = 2e-5;

struct Facet {
  Vector3d normal;
  double offset_m;
  Surface surface;
};

Facet facet_of(const Corners& corners, Surface surface) {
  const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double length = normal.norm();
  if (length == 0.0) return {Vector3d::UnitZ(), corners[0].z(), surface};
  return {normal / length, normal.dot(corners[0]) / length, surface};
}

struct SceneParts {
  std::vector<std::vector<Facet>> facets;  // A vector a geometry.

  /// Range at which the ray meets the triangle's plane.
  double range_m(std::uint32_t geometry, std::uint32_t triangle, const Vector3d& origin,
                 const Vector3d& direction) const {
    const Facet& facet = facets[geometry][triangle];
    return (facet.offset_m - facet.normal.dot(origin)) / facet.normal.dot(direction);
  }
};

struct DeviceRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

void set_up(RTCRayHit4& rays, const Vector3d& origin, const RayCaster::Four& directions, double max_range_m) {
  for (std::size_t i = 0; i < 4; ++i) {
    rays.ray.org_x[i] = static_cast<float>(origin.x());
    rays.ray.org_y[i] = static_cast<float>(origin.y());
    rays.ray.org_z[i] = static_cast<float>(origin.z());
    rays.ray.dir_x[i] = static_cast<float>(directions[i].x());
    rays.ray.dir_y[i] = static_cast<float>(directions[i].y());
    rays.ray.dir_z[i] = static_cast<float>(directions[i].z());
    rays.ray.tnear[i] = 0.0F;
    rays.ray.tfar[i] = static_cast<float>(max_range_m);
    rays.ray.time[i] = 0.0F;
    rays.ray.mask[i] = ~0U;
    rays.ray.id[i] = static_cast<unsigned>(i);
    rays.ray.flags[i] = 0;
    rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
}

}  // namespace

bool Hit::same_plane(const Hit& other) const {
  return surface.material == other.surface.material && surface.label == other.surface.label &&
         (normal - other.normal).cwiseAbs().maxCoeff() < kSameNormal &&
         std::fabs(offset_m - other.offset_m) < kSameOffset_m;
}

struct RayCaster::Scene : SceneParts {
  std::unique_ptr<RTCDeviceTy, DeviceRelease> device{rtcNewDevice(kDeviceSettings)};
  std::unique_ptr<RTCSceneTy, SceneRelease> scene;

  Scene() {
    if (!device) throw std::runtime_error("the ray caster cannot start: Embree gives no device");
    scene.reset(rtcNewScene(device.get()));
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  }

  void add(const Mesh& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<Eigen::Vector3f*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Eigen::Vector3f), mesh.vertices().size()));
    std::copy(mesh.vertices().begin(), mesh.vertices().end(), vertices);
    auto* indices = static_cast<std::array<std::uint32_t, 3>*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(std::array<std::uint32_t, 3>), mesh.triangles().size()));
    std::copy(mesh.triangles().begin(), mesh.triangles().end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    std::vector<Facet>& of_mesh = facets.emplace_back();
    of_mesh.reserve(mesh.size());
    for (std::size_t i = 0; i < mesh.size(); ++i) of_mesh.push_back(facet_of(mesh.corners(i), mesh.surface(i)));
  }
};

namespace {

/// Looks at every surface that the rays meet, and keeps the nearest by its range in double.
class TieBreak {
 public:
  struct Candidate {
    double range_m;
    std::uint32_t geometry, triangle;
    auto operator<=>(const Candidate&) const = default;
  };

  TieBreak(const SceneParts& scene, const RTCRayHit4& rays) : scene_(scene) {
    rtcInitIntersectContext(&asked_.context);
    asked_.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    asked_.context.filter = look;
    asked_.self = this;
    for (std::size_t i = 0; i < 4; ++i) {
      origin_[i] = {rays.ray.org_x[i], rays.ray.org_y[i], rays.ray.org_z[i]};
      direction_[i] = {rays.ray.dir_x[i], rays.ray.dir_y[i], rays.ray.dir_z[i]};
      about_m_[i] = rays.ray.tfar[i];
      if (rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) consider(i, rays.hit.geomID[i], rays.hit.primID[i]);
    }
  }

  RTCIntersectContext* context() { return &asked_.context; }
  const std::optional<Candidate>& best(std::size_t i) const { return best_[i]; }

 private:
  /// Embree passes its context back; what follows it is ours.
  struct Asked {
    RTCIntersectContext context;
    TieBreak* self;
  };

  void consider(std::size_t i, std::uint32_t geometry, std::uint32_t triangle) {
    double range = scene_.range_m(geometry, triangle, origin_[i], direction_[i]);
    if (!(std::fabs(range - about_m_[i]) < kRangeTrust_m)) range = about_m_[i];
    const Candidate candidate{range, geometry, triangle};
    if (!best_[i] || candidate < *best_[i]) best_[i] = candidate;
  }

  static void look(const RTCFilterFunctionNArguments* found) {
    TieBreak* self = reinterpret_cast<Asked*>(found->context)->self;
    for (unsigned k = 0; k < found->N; ++k) {
      if (found->valid[k] == 0) continue;
      found->valid[k] = 0;  // Not taken, so that Embree goes on looking.
      self->consider(RTCRayN_id(found->ray, found->N, k), RTCHitN_geomID(found->hit, found->N, k),
                     RTCHitN_primID(found->hit, found->N, k));
    }
  }

  const SceneParts& scene_;
  Asked asked_{};
  std::array<Vector3d, 4> origin_, direction_;
  std::array<double, 4> about_m_{};  // By Embree.
  std::array<std::optional<Candidate>, 4> best_;
};

/// Cuts the rays that met something to the stretch about it, and leaves out the others.
void narrow_to_ties(RTCRayHit4& rays, int (&valid)[4]) {
  for (std::size_t i = 0; i < 4; ++i) {
    valid[i] = rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? 0 : -1;
    const float range = rays.ray.tfar[i], slack = static_cast<float>(kTie_m) + range * static_cast<float>(kTieShare);
    rays.ray.tnear[i] = std::max(0.0F, range - slack);
    rays.ray.tfar[i] = range + slack;
    rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
}

}  // namespace

RayCaster::RayCaster(std::span<const Mesh* const> meshes) : scene_(std::make_unique<Scene>()) {
  for (const Mesh* mesh : meshes) {
    if (mesh->size() > 0) scene_->add(*mesh);
  }
  // With one thread the tree is the same each time, and so is the answer where two triangles are equally near.
  tbb::task_arena alone(1);
  alone.execute([&] { rtcCommitScene(scene_->scene.get()); });
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

RayCaster::FourHits RayCaster::cast(const Vector3d& origin, const Four& directions, double max_range_m) const {
  alignas(16) RTCRayHit4 rays;
  set_up(rays, origin, directions, max_range_m);
  alignas(16) int valid[4];  // Embree ends the process for a ray that is none.
  for (std::size_t i = 0; i < 4; ++i) valid[i] = origin.allFinite() && directions[i].allFinite() ? -1 : 0;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect4(valid, scene_->scene.get(), &context, &rays);
  TieBreak ties(*scene_, rays);
  narrow_to_ties(rays, valid);
  rtcIntersect4(valid, scene_->scene.get(), ties.context(), &rays);
  FourHits hits;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!ties.best(i)) continue;
    const auto& [range, geometry, triangle] = *ties.best(i);
    const Facet& facet = scene_->facets[geometry][triangle];
    hits[i] = Hit{range, facet.normal, facet.offset_m, facet.surface};
  }
  return hits;
}

std::optional<Hit> RayCaster::cast(const Vector3d& origin, const Vector3d& direction, double max_range_m) const {
  return cast(origin, Four{direction, direction, direction, direction}, max_range_m)[0];
}

}  // namespace scanway::simulator
