#include "modules/simulator/core/ray/ray_caster.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

namespace scanway::simulator {
namespace {

using Eigen::Vector3d;

// One instruction set for all CPUs: with AVX2 Embree would use fused multiply-adds, and answer otherwise at edges.
constexpr const char* kDeviceSettings = "isa=sse4.2";
// Of one plane are surfaces whose normals and offsets differ by no more than what floats make of coordinates.
constexpr double kSameNormal = 1e-5;
constexpr double kSameOffset_m = 2e-5;
// Farther off Embree's own range than this, the plane's is of no use: the ray all but lies in it.
constexpr double kRangeTrust_m = 0.02;

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
    rays.ray.id[i] = 0;
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

struct RayCaster::Scene {
  std::unique_ptr<RTCDeviceTy, DeviceRelease> device{rtcNewDevice(kDeviceSettings)};
  std::unique_ptr<RTCSceneTy, SceneRelease> scene;
  std::vector<std::vector<Facet>> facets;  // A vector a geometry.

  Scene() {
    if (!device) throw std::runtime_error("the ray caster cannot start: Embree gives no device");
    scene.reset(rtcNewScene(device.get()));
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
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

  std::optional<Hit> hit(std::uint32_t geometry, std::uint32_t triangle, const Vector3d& origin,
                         const Vector3d& direction, double embree_range_m) const {
    if (geometry == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const Facet& facet = facets[geometry][triangle];
    double range = (facet.offset_m - facet.normal.dot(origin)) / facet.normal.dot(direction);
    if (!(std::fabs(range - embree_range_m) < kRangeTrust_m)) range = embree_range_m;
    return Hit{range, facet.normal, facet.offset_m, facet.surface};
  }
};

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
  alignas(16) constexpr int kAll[4] = {-1, -1, -1, -1};
  alignas(16) RTCRayHit4 rays;
  set_up(rays, origin, directions, max_range_m);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect4(kAll, scene_->scene.get(), &context, &rays);
  FourHits hits;
  for (std::size_t i = 0; i < 4; ++i) {
    hits[i] = scene_->hit(rays.hit.geomID[i], rays.hit.primID[i], origin, directions[i],
                          static_cast<double>(rays.ray.tfar[i]));
  }
  return hits;
}

std::optional<Hit> RayCaster::cast(const Vector3d& origin, const Vector3d& direction, double max_range_m) const {
  return cast(origin, Four{direction, direction, direction, direction}, max_range_m)[0];
}

}  // namespace scanway::simulator
