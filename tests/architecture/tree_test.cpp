// The source tree keeps the rules.
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include <gtest/gtest.h>

#include "tests/architecture/rules.h"

namespace scanway::architecture {
namespace {

const std::vector<SourceFile>& tree() {
  static const std::vector<SourceFile> kTree = source_files(SCANWAY_SOURCE_DIR);
  return kTree;
}

void expect_none(const Violations& violations) {
  for (const std::string& violation : violations) ADD_FAILURE() << violation;
}

TEST(Tree, IsSeen) {
  const auto has = [](const std::string& path) { return std::ranges::count(tree(), path, &SourceFile::path) == 1; };
  EXPECT_TRUE(has("common/grid/cost_map.h"));
  EXPECT_TRUE(has("modules/tools/main.cpp"));
  EXPECT_TRUE(has("CMakeLists.txt"));
}

TEST(Tree, IncludesInOneDirection) {
  for (const SourceFile& file : tree()) {
    if (is_cpp(file)) expect_none(include_violations(file));
  }
}

TEST(Tree, CoresArePure) {
  for (const SourceFile& file : tree()) {
    if (is_cpp(file)) expect_none(purity_violations(file));
  }
}

TEST(Tree, NamesNoPathOfOneMachine) {
  for (const SourceFile& file : tree()) expect_none(machine_path_violations(file));
}

TEST(Tree, FilesAreShort) {
  constexpr long kMany = 240, kTooMany = 400;
  for (const SourceFile& file : tree()) {
    for (const std::string& line : length_violations(file, kMany)) std::printf("long: %s\n", line.c_str());
    expect_none(length_violations(file, kTooMany));
  }
}

TEST(Tree, CommandsAreDocumented) { expect_none(undocumented_commands(tree())); }

/// What a command prints, and whether it ended with 0.
std::pair<std::string, bool> run(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> part{};
  while (const std::size_t n = fread(part.data(), 1, part.size(), pipe)) output.append(part.data(), n);
  return {output, pclose(pipe) == 0};
}

TEST(Tree, IsFormatted) {
  if (!run("clang-format --version").second) GTEST_SKIP() << "clang-format is not installed";
  std::string files;
  for (const SourceFile& file : tree()) {
    if (is_cpp(file)) files += " '" + std::string(SCANWAY_SOURCE_DIR) + "/" + file.path + "'";
  }
  const auto [output, clean] = run("clang-format --dry-run --Werror --ferror-limit=1" + files);
  EXPECT_TRUE(clean) << output << "\nrun clang-format -i on these files";
}

}  // namespace
}  // namespace scanway::architecture
