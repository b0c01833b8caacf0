// The map of a yard of 40 m over a link of 2 Mbit/s, and with 5 % of its frames lost.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>
#include <tuple>

#include "common/cloud/read_cloud.h"
#include "common/files/saved_folder.h"
#include "tests/live/support/session.h"
#include "tests/support/command.h"

namespace scanway::test {
namespace {

const std::string kBin = SCANWAY_BIN_DIR;
constexpr double kLimit = 60.0;  // seconds

/// Two sweeps of the yard with a ninth of their points, and the map that is made of them.
struct Yard {
  static const Yard& get() {
    static const Yard kYard;
    return kYard;
  }

  ScratchFolder folder;
  std::string map = folder / "map";

 private:
  Yard() {
    const auto succeed = [](const std::vector<std::string>& words) {
      const CommandResult result = run_command(words);
      EXPECT_EQ(result.status, 0) << words[1] << ": " << result.err;
    };
    succeed({kBin + "/scanway", "simulate", "sweep", "--world", "yard", "--thin", "3", "--pose", "0,0,0", "--pose",
             "5,2,0", "-o", folder / "yard.lcm"});
    succeed({kBin + "/scanway", "replay", folder / "yard.lcm", "-o", map});
  }
};

constexpr const char* kRobot = R"(
  tc qdisc add dev eth0 root tbf rate 2mbit burst 10k latency 400ms || exit 125
  "$BIN/scanway-mapper" --lcm-url "$NEAR" --resume "$MAP" 2>"$WORK/mapper.err" &
  until grep -q ready "$WORK/mapper.err"; do sleep 0.2; done
  "$BIN/scanway-link" --near "$NEAR" --far "$FAR" 2>"$WORK/link.err" &
  until grep -q ready "$WORK/link.err"; do sleep 0.2; done
  sleep 10  # The link has the map now.
  touch "$LAN_DIR/ready"
  wait)";

constexpr const char* kOperator = R"(
  tc qdisc add dev eth0 root tbf rate 2mbit burst 10k latency 400ms || exit 125
  until [ -e "$LAN_DIR/ready" ]; do sleep 0.1; done
  "$BIN/scanway" map fetch --lcm-url "$FAR" --cloud 0.1 --octomap 0.2 --limit-s 150 -o "$WORK/fetched" \
    >"$WORK/fetch.txt" 2>"$WORK/fetch.err")";

class SlowLink : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    if (!namespaces_permitted()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  }
  CommandResult fetch_at_loss(int percent) const {
    const std::string head = "BIN='" + kBin + "' WORK='" + work_.path() + "' MAP='" + Yard::get().map +
                             "'\nNEAR='udpm://239.255.76.67:7667?ttl=0' FAR='udpm://239.255.76.68:7668?ttl=1'\n";
    write_text(work_ / "robot.sh", head + kRobot);
    write_text(work_ / "operator.sh", head + kOperator);
    return run_command({SCANWAY_SOURCE_DIR "/tests/tools/netns-lan", "-1", "-t", "400", "-l", std::to_string(percent),
                        "--", "exec bash '" + work_ / "robot.sh'", "exec bash '" + work_ / "operator.sh'"});
  }
  /// The lines of `scanway map fetch`: seconds and words.
  std::vector<std::pair<double, std::string>> said() const {
    std::vector<std::pair<double, std::string>> lines;
    std::istringstream text(read_text(work_ / "fetch.txt"));
    for (std::string line; std::getline(text, line);) lines.emplace_back(std::stod(line), line);
    return lines;
  }

  const ScratchFolder work_;
};

std::set<std::tuple<long, long, long>> voxels(const PointCloud& cloud, double voxel_m) {
  std::set<std::tuple<long, long, long>> voxels;
  const auto number = [voxel_m](float c) { return static_cast<long>(std::floor(static_cast<double>(c) / voxel_m)); };
  for (const auto& p : cloud.points) voxels.emplace(number(p.x()), number(p.y()), number(p.z()));
  return voxels;
}

TEST_P(SlowLink, BringsTheWholeMapInAMinute) {
  const CommandResult run = fetch_at_loss(GetParam());
  if (run.status == 125) GTEST_SKIP() << "no pretend link here: " << run.err;
  ASSERT_EQ(run.status, 0) << run.err << read_text(work_ / "fetch.txt") << read_text(work_ / "link.err");

  const std::string map = Yard::get().map, fetched = work_ / "fetched";
  EXPECT_NO_THROW(SavedFolder{fetched});
  EXPECT_EQ(read_text(fetched + "/costmap.pgm"), read_text(map + "/costmap.pgm"));
  EXPECT_EQ(read_text(fetched + "/costmap.yaml"), read_text(map + "/costmap.yaml"));
  const PointCloud coarse = read_cloud(fetched + "/map.pcd");
  const auto expected = voxels(read_cloud(map + "/map.pcd"), 0.1);
  EXPECT_NEAR(static_cast<double>(coarse.size()), static_cast<double>(expected.size()),
              1e-4 * static_cast<double>(expected.size()));

  const auto lines = said();
  ASSERT_GT(lines.size(), 3U);
  std::printf("%s\n", lines.back().second.c_str());
  EXPECT_LE(lines.back().first, kLimit);
  std::size_t meanwhile = 0;
  for (const auto& [seconds, line] : lines) meanwhile += line.find(" tiles here") != std::string::npos;
  EXPECT_GT(meanwhile, 3U) << "what it lacks is not told meanwhile";
}

INSTANTIATE_TEST_SUITE_P(PercentLost, SlowLink, testing::Values(0, 5), testing::PrintToStringParamName());

}  // namespace
}  // namespace scanway::test
