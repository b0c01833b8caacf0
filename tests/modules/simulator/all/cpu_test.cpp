#include <gtest/gtest.h>

#include "tests/end_to_end/scanway.h"

namespace scanway::test {
namespace {

class OnAnotherProcessor : public testing::TestWithParam<const char*> {};

TEST_P(OnAnotherProcessor, TheSweepHasTheSameBytes) {
  const ScratchFolder folder;
  const auto words = [&](const std::string& name) {
    return std::vector<std::string>{std::string(SCANWAY_BIN_DIR) + "/scanway",
                                    "simulate",
                                    "sweep",
                                    "--world",
                                    GetParam(),
                                    "--seed",
                                    "5",
                                    "--pose",
                                    std::string(GetParam()) == "street" ? "-13,-14.5,0" : "-8,0.5,0",
                                    "--thin",
                                    "8",
                                    "-o",
                                    folder / name};
  };
  ASSERT_EQ(run_command(words("here.pcd")).status, 0);
  std::vector<std::string> emulated = {"qemu-x86_64", "-cpu", "Nehalem-v1"};
  const std::vector<std::string> there = words("there.pcd");
  emulated.insert(emulated.end(), there.begin(), there.end());
  const CommandResult result = run_command(emulated);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(read_text(folder / "here.pcd") == read_text(folder / "there.pcd"));
}

INSTANTIATE_TEST_SUITE_P(Worlds, OnAnotherProcessor, testing::Values("street", "yard", "rubble", "hall"));

}  // namespace
}  // namespace scanway::test
