#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace scanway::test {
namespace {

const std::string kScanway = SCANWAY_BIN_DIR "/scanway";
const std::string kStreet = SCANWAY_SHARED_DIR "/data/street_pair_hdl32/";

#define SKIP_WITHOUT_DATA() \
  if (!std::filesystem::exists(kStreet)) GTEST_SKIP() << kStreet << " is not there: no real scans to register"

TEST(Register, PrintsOneJsonDocumentWithTheFixedKeys) {
  SKIP_WITHOUT_DATA();
  const CommandResult run = run_command(
      {kScanway, "register", kStreet + "source.ply", kStreet + "target.ply", "--orientation", "2,0,0,0", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const nlohmann::json json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json.at("T_target_source").size(), 16u);
  EXPECT_EQ(json.at("verdict"), "accepted") << json.at("reason");
  EXPECT_NEAR(json.at("T_target_source")[3], 0.488882, 0.1);
  EXPECT_NEAR(json.at("T_target_source")[7], 0.121214, 0.1);
  EXPECT_EQ(json.at("T_target_source")[15], 1.0);
  EXPECT_GT(json.at("probability"), 0.9);
  EXPECT_GT(json.at("overlap"), 0.7);
  EXPECT_LT(json.at("inlier_rmse_m"), 0.05);
  EXPECT_GT(json.at("seconds").at("total"), 0.0);
}

TEST(Register, SaysForPeopleWhatCameOut) {
  ScratchFolder folder;
  write_text(folder / "few.xyz", "1 2 3\n2 3 4\n5 1 2\n");
  const CommandResult run = run_command({kScanway, "register", folder / "few.xyz", folder / "few.xyz"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out.find("refused"), 0u) << run.out;
  EXPECT_NE(run.out.find("only 3 places"), std::string::npos) << run.out;
}

TEST(Register, RefusesAQuaternionThatIsNoRotation) {
  ScratchFolder folder;
  write_text(folder / "few.xyz", "1 2 3\n2 3 4\n5 1 2\n");
  for (const char* orientation : {"0,0,0,0", "nan,0,0,1", "inf,0,0,0"}) {
    const CommandResult run = run_command(
        {kScanway, "register", folder / "few.xyz", folder / "few.xyz", "--orientation", orientation, "--json"});
    EXPECT_EQ(run.status, 2) << orientation;
    EXPECT_TRUE(run.out.empty());
    EXPECT_NE(run.err.find("orientation"), std::string::npos) << run.err;
  }
}

TEST(Register, NamesAFileThatIsNotThere) {
  const CommandResult run = run_command({kScanway, "register", "/no/such.pcd", "/no/other.pcd"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("/no/such.pcd"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace scanway::test
