// `scanway map save`, killed at random moments over an older map.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <map>
#include <string>
#include <thread>

#include "common/cloud/read_cloud.h"
#include "common/cloud/write_cloud.h"
#include "common/files/saved_folder.h"
#include "common/random/random.h"
#include "tests/support/command.h"
#include "tests/support/program.h"

namespace scanway::test {
namespace {

const std::string kScanway = SCANWAY_BIN_DIR "/scanway";
constexpr int kTrials = 120;

using Files = std::map<std::string, std::uint64_t>;

void succeed(const std::vector<std::string>& words) {
  const CommandResult result = run_command(words);
  ASSERT_EQ(result.status, 0) << words[1] << " " << words[2] << ": " << result.err;
}

/// A small part of a scan of the halls, and the map that is made of it.
void make_map(const ScratchFolder& scratch, const std::string& name, const std::string& scan) {
  const PointCloud whole = read_cloud(SCANWAY_SOURCE_DIR "/logs/halls/" + scan);
  PointCloud part;
  for (std::size_t i = 0; i < whole.size(); i += 12) part.points.push_back(whole.points[i]);
  write_pcd(scratch / scan, part);
  succeed({kScanway, "import", "clouds", scratch / scan, "-o", scratch / name + ".lcmlog"});
  succeed({kScanway, "replay", scratch / name + ".lcmlog", "-o", scratch / name});
}

TEST(KilledSave, LeavesTheOldMapOrTheNewOne) {
  const ScratchFolder scratch;
  make_map(scratch, "one", "scan000.pcd");
  make_map(scratch, "other", "scan001.pcd");
  const std::string folder = scratch / "map";
  const auto begin = std::chrono::steady_clock::now();
  succeed({kScanway, "map", "save", scratch / "one", "-o", folder});
  double whole_us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
  const Files one = SavedFolder(folder).digests();
  succeed({kScanway, "map", "save", scratch / "other", "-o", folder});
  const Files other = SavedFolder(folder).digests();
  ASSERT_NE(one, other);

  Random random(3);
  int killed = 0, replaced = 0;
  Files held = other;
  for (int trial = 0; trial < kTrials; ++trial) {
    Program saver({kScanway, "map", "save", scratch / (held == one ? "other" : "one"), "-o", folder}, "/dev/null");
    std::this_thread::sleep_for(std::chrono::microseconds(static_cast<long>(whole_us * (0.3 + random.uniform()))));
    if (saver.end(SIGKILL) == 128 + SIGKILL) ++killed;
    succeed({kScanway, "map", "check", folder});
    const Files now = SavedFolder(folder).digests();
    ASSERT_TRUE(now == one || now == other) << "trial " << trial << ": neither the old map nor the new one";
    if (now != held) ++replaced;
    // How long a save takes depends on what else the machine does at the time, so the moments follow it.
    whole_us *= now != held ? 0.9 : 1.1;
    held = now;
  }
  std::printf("%d of %d savers were killed at work; the map was replaced %d times\n", killed, kTrials, replaced);
  EXPECT_GT(killed, kTrials / 4);
  EXPECT_GT(replaced, kTrials / 10);
}

}  // namespace
}  // namespace scanway::test
