// The rules themselves: each finds what was planted, and leaves the permitted thing beside it alone.
#include "tests/architecture/rules.h"

#include <gtest/gtest.h>

namespace scanway::architecture {
namespace {

struct Planted {
  const char* path;
  const char* text;
};

class BadInclude : public testing::TestWithParam<Planted> {};
TEST_P(BadInclude, IsFound) { EXPECT_EQ(include_violations({GetParam().path, GetParam().text}).size(), 1u); }
INSTANTIATE_TEST_SUITE_P(
    All, BadInclude,
    testing::Values(Planted{"modules/mapper/core/a.cpp", "#include \"modules/planner/core/b.h\"\n"},
                    Planted{"modules/mapper/core/a.cpp", "#include \"modules/mapper/node/b.h\"\n"},
                    Planted{"modules/mapper/core/a.cpp", "#include \"common/files/read_file.h\"\n"},
                    Planted{"modules/mapper/core/a.cpp", "#include \"common/cloud/read_cloud.h\"\n"},
                    Planted{"modules/mapper/core/a.cpp", "#include \"common/grid/map_file.h\"\n"},
                    Planted{"modules/mapper/core/a.cpp", "#include \"common/bus/bus.h\"\n"},
                    Planted{"modules/mapper/core/a.cpp", "#  include <lcm/lcm-cpp.hpp>\n"},
                    Planted{"modules/mapper/core/a.cpp", "#include \"scanway/goal_t.hpp\"\n"},
                    Planted{"modules/sick_bridge/device/a.cpp", "#include \"common/bus/bus.h\"\n"},
                    Planted{"modules/sick_bridge/device/a.cpp", "#include \"scanway/laser_line_t.hpp\"\n"},
                    Planted{"modules/mapper/node/a.cpp", "#include \"modules/planner/node/b.h\"\n"},
                    Planted{"modules/mapper/node/a.cpp", "#include \"tests/support/command.h\"\n"},
                    Planted{"common/cloud/a.h", "#include \"modules/mapper/core/b.h\"\n"},
                    Planted{"common/cloud/a.h", "#include \"bot_core/pose_t.hpp\"\n"},
                    Planted{"common/config/a.h", "#include \"common/messages/b.h\"\n"}));

class GoodInclude : public testing::TestWithParam<Planted> {};
TEST_P(GoodInclude, IsLeftAlone) { EXPECT_TRUE(include_violations({GetParam().path, GetParam().text}).empty()); }
INSTANTIATE_TEST_SUITE_P(
    All, GoodInclude,
    testing::Values(Planted{"modules/mapper/core/a.cpp", "#include \"modules/mapper/core/x/b.h\"\n"},
                    Planted{"modules/mapper/core/a.cpp", "#include \"common/cloud/point_cloud.h\"\n"},
                    Planted{"modules/mapper/core/a.cpp", "#include <vector>\n"},
                    Planted{"modules/mapper/node/a.cpp", "#include \"scanway/goal_t.hpp\"\n"},
                    Planted{"modules/sick_bridge/device/a.cpp", "#include \"common/serial/serial_port.h\"\n"},
                    Planted{"modules/replay/a.cpp", "#include \"modules/mapper/node/b.h\"\n"},
                    Planted{"modules/tools/a.cpp", "#include \"modules/planner/core/b.h\"\n"},
                    Planted{"common/bus/a.h", "#include \"lcmtypes/all_types.h\"\n"},
                    Planted{"tests/a.cpp", "#include \"tests/b.h\"\n"}));

class ImpureLine : public testing::TestWithParam<const char*> {};
TEST_P(ImpureLine, IsFoundInACore) {
  EXPECT_FALSE(purity_violations({"modules/mapper/core/a.cpp", GetParam()}).empty());
  EXPECT_FALSE(purity_violations({"common/geometry/a.cpp", GetParam()}).empty());
  EXPECT_TRUE(purity_violations({"modules/mapper/node/a.cpp", GetParam()}).empty());
}
INSTANTIATE_TEST_SUITE_P(All, ImpureLine,
                         testing::Values("#include <chrono>", "auto t = std::chrono::steady_clock::now();",
                                         "x = time(nullptr);", "gettimeofday(&now, nullptr);", "#include <random>",
                                         "std::mt19937 g(1);", "int r = rand();",
                                         "std::shuffle(a.begin(), a.end(), g);", "#include <fstream>",
                                         "std::ofstream out(path);", "std::cerr << x;", "printf(text);",
                                         "lcm::LCM bus;", "#include <spdlog/spdlog.h>", "double y = std::sin(x);",
                                         "double y = sin(x);", "y = a*cos (x);", "y = ::exp(x);",
                                         "y = v.array().exp().sum();", "y = atan2f(a, b);", "auto f = std::pow(x, 2);",
                                         "y = -log(x);", "return hypot(a, b);", "std::transform(a, b, c, std::exp);",
                                         "Eigen::AngleAxisd(a, axis)", "R.eulerAngles(0, 1, 2);", "using std::cos;"));

class PureLine : public testing::TestWithParam<const char*> {};
TEST_P(PureLine, IsLeftAlone) { EXPECT_TRUE(purity_violations({"modules/mapper/core/a.cpp", GetParam()}).empty()); }
INSTANTIATE_TEST_SUITE_P(All, PureLine,
                         testing::Values("y = repeatable::sin(x) + std::sqrt(x);", "// std::sin(x) differs, rand() too",
                                         "/* time(nullptr) */", "fail(\"std::cout << exp(x)\");",
                                         "begin_stage(s, \"icp\");", "w = log_so3(R); R = exp_so3(w);",
                                         "point.time(3);", "sweep.utime(0);", "Random random(seed); random.uniform();",
                                         "dispatch::exp(x);", "const int cosine(3);", "double operand(int);",
                                         "catalog(3);", "constexpr int k = 1'000'000; y = x;"));

TEST(MachinePath, IsFoundInAnyText) {
  const std::string work = "/wo", home = "/ho";
  EXPECT_EQ(machine_path_violations({"docs/a.md", "see " + work + "rk/main"}).size(), 1u);
  EXPECT_EQ(machine_path_violations({"launch/a", "cd " + home + "me/ann"}).size(), 1u);
  EXPECT_TRUE(machine_path_violations({"docs/a.md", "a frame" + work + "rk of home" + home + "me"}).empty());
}

TEST(Length, CountsLinesOfCode) {
  std::string text;
  for (int i = 0; i < 241; ++i) text += "x\n";
  EXPECT_EQ(length_violations({"common/a.cpp", text}, 240).size(), 1u);
  EXPECT_TRUE(length_violations({"common/a.cpp", text}, 241).empty());
  EXPECT_TRUE(length_violations({"logs/a.csv", text}, 240).empty());
}

TEST(Commands, MustStandInTheDocs) {
  const SourceFile header{"modules/tools/fly.h", "/// `scanway fly`: up.\nint run_fly(const FlyOptions& options);\n"};
  const SourceFile nameless{"modules/tools/run.h", "int run_run(const Options& options);\n"};
  EXPECT_EQ(undocumented_commands({header}).size(), 1u);
  EXPECT_EQ(undocumented_commands({header, {"docs/b.md", "scanway swim"}}).size(), 1u);
  EXPECT_TRUE(undocumented_commands({header, {"docs/b.md", "type `scanway fly --high`"}}).empty());
  EXPECT_EQ(undocumented_commands({nameless, {"docs/b.md", "scanway run"}}).size(), 1u);
}

TEST(Code, HasNeitherCommentsNorLiterals) {
  EXPECT_EQ(code_of("a // b\nc /* d\ne */ f"), "a  \nc  \n f");
  EXPECT_EQ(code_of("x(\"a\\\"b\", 'c', R\"--(y\")--\")"), "x( ,  ,  )");
  EXPECT_EQ(code_of("1'000 + 2"), "1'000 + 2");
}

}  // namespace
}  // namespace scanway::architecture
