#include "tests/bench/ground/aerial/sample.h"

#include <array>
#include <cmath>
#include <map>

#include "common/cloud/read_cloud.h"
#include "common/files/input_error.h"

namespace scanway::bench {
namespace {

using Key = std::array<float, 3>;

Key key_of(const Eigen::Vector3f& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

double Sample::spacing_m() const {
  Eigen::Vector2d low = points.front().head<2>(), high = low;
  for (const Eigen::Vector3d& p : points) low = low.cwiseMin(p.head<2>()), high = high.cwiseMax(p.head<2>());
  return std::sqrt((high - low).prod() / static_cast<double>(points.size()));
}

Sample read_sample(const std::string& folder, const std::string& name) {
  const PointCloud all = read_cloud(folder + "/" + name + "-utm.pcd");
  const PointCloud ground = read_cloud(folder + "/" + name + "-utm-ground.pcd");
  std::map<Key, int> left;  // of the reference's points, which are some of all
  for (const Eigen::Vector3f& p : ground.points) ++left[key_of(p)];
  Sample sample{name, {}, {}};
  std::size_t found = 0;
  for (const Eigen::Vector3f& p : all.points) {
    sample.points.push_back(p.cast<double>() - all.points.front().cast<double>());
    const auto of_ground = left.find(key_of(p));
    sample.ground.push_back(of_ground != left.end() && of_ground->second-- > 0);
    found += sample.ground.back() ? 1 : 0;
  }
  if (found != ground.size()) throw InputError(name + "-utm-ground.pcd: has points that " + name + "-utm.pcd lacks");
  return sample;
}

Errors errors_of(const Sample& sample, const std::vector<bool>& called_ground) {
  double ground = 0, lost = 0, objects = 0, taken = 0;
  for (std::size_t i = 0; i < sample.points.size(); ++i) {
    (sample.ground[i] ? ground : objects) += 1;
    if (sample.ground[i] && !called_ground[i]) ++lost;
    if (!sample.ground[i] && called_ground[i]) ++taken;
  }
  return {100 * lost / ground, 100 * taken / objects, 100 * (lost + taken) / (ground + objects)};
}

}  // namespace scanway::bench
