// What the Procfiles start is there, and takes the options that it is given.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "tests/support/command.h"

namespace scanway::test {
namespace {

class Procfile : public testing::TestWithParam<const char*> {};

TEST_P(Procfile, StartsProgramsThatTakeItsOptions) {
  const std::regex line_form(
      "^[a-z]+: launch/keep (?:\\$SCANWAY_AT_ONCE )?\"?(?:build|\\$SCANWAY_BUILD)/bin/(scanway-[a-z]+)\"? (.*)$"),
      option_form("--[a-z-]+");
  std::istringstream lines(read_text(std::string(SCANWAY_SOURCE_DIR) + "/launch/" + GetParam()));
  int programs = 0;
  for (std::string line; std::getline(lines, line); ++programs) {
    std::smatch parts;
    ASSERT_TRUE(std::regex_match(line, parts, line_form)) << line;
    const auto help = run_command({std::string(SCANWAY_BIN_DIR) + "/" + parts[1].str(), "--help"});
    EXPECT_EQ(help.status, 0) << line << help.err;
    const std::string options = parts[2].str();
    for (auto option = std::sregex_iterator(options.begin(), options.end(), option_form);
         option != std::sregex_iterator(); ++option) {
      EXPECT_NE(help.out.find(option->str()), std::string::npos) << line;
    }
  }
  EXPECT_GE(programs, 2);
}

INSTANTIATE_TEST_SUITE_P(All, Procfile, testing::Values("Procfile", "Procfile.robot", "Procfile.sim"));

}  // namespace
}  // namespace scanway::test
