// Seven halls in a row through import and replay, with five trackers that are off in different ways.

#include <filesystem>
#include <map>

#include <nlohmann/json.hpp>

#include "common/cloud/poses_file.h"
#include "common/geometry/pose.h"
#include "tests/end_to_end/scanway.h"

namespace scanway::test {
namespace {

const std::string kHalls = std::string(SCANWAY_SHARED_DIR) + "/data/hall_scans_a";
constexpr double kDegree = 3.14159265358979 / 180.0;

class Halls : public testing::TestWithParam<int> {};

Pose pose_of(const nlohmann::json& numbers) {
  Pose pose;
  for (int i = 0; i < 16; ++i) pose.matrix()(i / 4, i % 4) = numbers[i];
  return pose;
}

std::vector<std::string> import_words(const std::string& seed, const std::string& log) {
  std::vector<std::string> words = {"import", "clouds"};
  for (int scan = 0; scan < 7; ++scan) words.push_back(kHalls + "/scan00" + std::to_string(scan) + ".pcd");
  for (const std::string& word :
       {std::string("--poses"), kHalls + "/poses_reference.txt", std::string("--heading-sigma-deg"), std::string("5"),
        std::string("--tilt-sigma-deg"), std::string("0.5"), std::string("--seed"), seed, std::string("-o"), log}) {
    words.push_back(word);
  }
  return words;
}

TEST_P(Halls, NeighboursAreAcceptedNearTheirReference) {
  if (!std::filesystem::exists(kHalls)) GTEST_SKIP() << kHalls << " is not there";
  const ScratchFolder folder;
  ASSERT_EQ(run_scanway(import_words(std::to_string(GetParam()), folder / "halls.lcmlog")).status, 0);
  ASSERT_EQ(run_scanway({"replay", folder / "halls.lcmlog", "-o", folder / "out"}).status, 0);
  const auto report = nlohmann::json::parse(read_text(folder / "out/report.json"));
  const PosesFile poses = PosesFile::read(kHalls + "/poses_reference.txt");
  std::map<std::string, Pose> placed;
  ASSERT_EQ(report["scans"].size(), 7u);
  for (const auto& scan : report["scans"]) {
    const std::string name = scan["name"], target = scan["target"];
    EXPECT_EQ(scan["verdict"], "accepted") << name << ": " << scan["reason"];
    placed[name] = pose_of(scan["T_map_scan"]);
    if (target.empty()) continue;
    const Pose truth = poses.pose_of(target).inverse() * poses.pose_of(name);
    const Pose difference = truth.inverse() * (placed.at(target).inverse() * placed.at(name));
    EXPECT_LT(difference.translation().norm(), 0.05) << name << " to " << target;
    EXPECT_LT(rotation_angle(difference.linear()), 0.3 * kDegree) << name << " to " << target;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Halls, testing::Range(1, 6));

}  // namespace
}  // namespace scanway::test
