#include "tests/bench/registration/real_pairs.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/cloud/poses_file.h"
#include "common/cloud/read_cloud.h"
#include "common/files/input_error.h"
#include "common/math/repeatable.h"
#include "modules/mapper/core/registration/cell_grid.h"

namespace scanway::bench {
namespace {

constexpr double kDegree = repeatable::kPi / 180.0;

struct SetFacts {
  const char* name;
  double min_range_m;
  double right_m;
  double right_deg;
};

constexpr SetFacts kFacts[] = {
    {"hall_scans_a", 0.3, 0.05, 0.3},         {"corridor_tilting_sick_3dtk", 0.3, 0.05, 0.5},
    {"street_pair_hdl32", 0.3, 0.1, 0.5},     {"street_kitti00", 2.5, 0.1, 0.5},
    {"tilted_velodyne_lpm", 0.3, 0.05, 0.45}, {"handheld_os0_balm", 0.3, 0.1, 0.5},
};

const SetFacts& facts_of(const std::string& name) {
  for (const SetFacts& facts : kFacts) {
    if (name == facts.name) return facts;
  }
  throw InputError("No set " + name + " is known");
}

PointCloud without_near(PointCloud cloud, double min_range_m) {
  std::erase_if(cloud.points, [&](const Eigen::Vector3f& p) { return p.norm() < min_range_m; });
  cloud.intensity.clear();
  return cloud;
}

std::string file_of(const std::filesystem::path& folder, const std::string& scan) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (scan_name(entry.path().string()) == scan && !name.ends_with(".pose")) found.push_back(entry.path().string());
  }
  if (found.size() != 1) throw InputError(folder.string() + ": no scan " + scan);
  return found.front();
}

std::vector<std::string> names_in(const std::string& poses) {
  std::vector<std::string> names;
  std::ifstream file(poses);
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line[0] != '#') names.push_back(line.substr(0, line.find(' ')));
  }
  return names;
}

/// The table's columns: A, B, displacement, rotation, two before and two after, the overlap at the reference last.
std::map<std::pair<std::string, std::string>, double> overlaps_in(const std::string& readme) {
  std::map<std::pair<std::string, std::string>, double> overlaps;
  std::ifstream file(readme);
  for (std::string line; std::getline(file, line);) {
    std::replace(line.begin(), line.end(), '|', ' ');
    std::istringstream row(line);
    std::string a, b;
    double figure = 0.0, last = 0.0;
    int figures = 0;
    for (row >> a >> b; row >> figure; ++figures) last = figure;
    if (figures == 6) overlaps[{a, b}] = last;
  }
  return overlaps;
}

RealSet load_street_pair(const std::string& folder) {
  RealSet set;
  set.scans = {"target", "source"};
  Eigen::Matrix4d T;
  std::ifstream file(folder + "/T_target_source.txt");
  for (int i = 0; i < 16; ++i) file >> T(i / 4, i % 4);
  Pose pose;
  pose.matrix() = T;
  pose.linear() = nearest_rotation(pose.linear());
  set.X_ref_scan = {Pose::Identity(), pose};
  for (const std::string& scan : set.scans) set.clouds.push_back(read_cloud(folder + "/" + scan + ".ply"));
  return set;
}

}  // namespace

const std::vector<std::string>& real_set_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const SetFacts& facts : kFacts) names.emplace_back(facts.name);
    return names;
  }();
  return kNames;
}

RealSet load_set(const std::string& data, const std::string& name) {
  const SetFacts& facts = facts_of(name);
  const std::string folder = data + "/" + name, poses = folder + "/poses_reference.txt";
  RealSet set;
  if (name == "street_pair_hdl32") {
    set = load_street_pair(folder);
  } else {
    const PosesFile reference = PosesFile::read(poses);
    for (const std::string& scan : names_in(poses)) {
      set.scans.push_back(scan);
      set.clouds.push_back(read_cloud(file_of(folder, scan)));
      set.X_ref_scan.push_back(reference.pose_of(scan));
      set.X_ref_scan.back().linear() = nearest_rotation(set.X_ref_scan.back().linear());
    }
  }
  for (PointCloud& cloud : set.clouds) cloud = without_near(std::move(cloud), facts.min_range_m);
  set.stated_overlap = overlaps_in(folder + "/README.md");
  set.name = name;
  set.right_m = facts.right_m;
  set.right_angle = facts.right_deg * kDegree;
  return set;
}

OrientationPrior disturbed_prior(const Pose& T_target_source, double heading_sigma_deg, double tilt_sigma_deg,
                                 Random& random) {
  OrientationPrior prior;
  const double roll = random.normal() * tilt_sigma_deg * kDegree, pitch = random.normal() * tilt_sigma_deg * kDegree;
  const double heading = random.normal() * heading_sigma_deg * kDegree;
  prior.R_target_source =
      rotation_about_z(heading) * exp_so3(Eigen::Vector3d(roll, pitch, 0.0)) * T_target_source.linear();
  prior.heading_sigma = heading_sigma_deg * kDegree;
  prior.tilt_sigma = tilt_sigma_deg * kDegree;
  return prior;
}

OrientationPrior turned_prior(const Pose& T_target_source, double angle_deg, Random& random) {
  const Eigen::Vector3d axis = Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
  OrientationPrior prior;
  prior.R_target_source = exp_so3(axis * angle_deg * kDegree) * T_target_source.linear();
  return prior;
}

PoseError error_of(const Pose& T, const Pose& reference) {
  const Pose d = reference.inverse() * T;
  return {(T.translation() - reference.translation()).norm(), rotation_angle(d.linear())};
}

double true_overlap(const PointCloud& source, const PointCloud& target, const Pose& T_target_source) {
  const registration::CellGrid grid(target.points, 0.3f);
  std::size_t near = 0, total = 0;
  for (std::size_t i = 0; i < source.size(); i += 3, ++total) {
    near += grid.any_within((T_target_source * source.points[i].cast<double>()).cast<float>(), 0.3f) ? 1 : 0;
  }
  return total > 0 ? static_cast<double>(near) / static_cast<double>(total) : 0.0;
}

}  // namespace scanway::bench
