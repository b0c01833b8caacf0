#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "modules/simulator/core/world/mesh.h"

namespace scanway::simulator {

/// Where a ray met a surface first.
struct Hit {
  double range_m = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< Of the surface; unit length.
  double offset_m = 0.0;                             ///< The surface's plane: normal . p = offset.
  Surface surface;

  /// Whether both lie in one plane of one surface.
  bool same_plane(const Hit& other) const;
};

/// Shoots rays at meshes (Embree, robust mode). Each ray has one answer, whatever the thread and whatever is shot
/// before it: Embree finds the triangle, with one instruction set on every CPU, and the range is then computed in
/// double from the triangle's plane.
class RayCaster {
 public:
  /// The meshes need not outlive this.
  explicit RayCaster(std::span<const Mesh* const> meshes);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  using Four = std::array<Eigen::Vector3d, 4>;
  using FourHits = std::array<std::optional<Hit>, 4>;

  /// Four rays from one origin at once; directions are unit vectors. Thread-safe.
  FourHits cast(const Eigen::Vector3d& origin, const Four& directions, double max_range_m) const;
  std::optional<Hit> cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double max_range_m) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace scanway::simulator
