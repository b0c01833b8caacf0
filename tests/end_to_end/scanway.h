#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/command.h"

namespace scanway::test {

/// Runs the built `scanway` with these words.
inline CommandResult run_scanway(std::vector<std::string> words, const std::vector<std::string>& environment = {}) {
  words.insert(words.begin(), std::string(SCANWAY_BIN_DIR) + "/scanway");
  return run_command(words, environment);
}

inline std::string hall(const std::string& name) { return std::string(SCANWAY_SOURCE_DIR) + "/logs/halls/" + name; }
inline std::string hall_poses() { return hall("poses_reference.txt"); }

/// The words that import these hall scans as the demo does.
inline std::vector<std::string> import_halls(const std::vector<std::string>& scans, const std::string& log) {
  std::vector<std::string> words = {"import", "clouds"};
  for (const std::string& scan : scans) words.push_back(hall(scan));
  for (const char* word :
       {"--poses", "", "--heading-sigma-deg", "5", "--tilt-sigma-deg", "0.5", "--goal", "1.0,-0.5", "-o", ""}) {
    words.emplace_back(word);
  }
  words[2 + scans.size() + 1] = hall_poses();
  words.back() = log;
  return words;
}

/// Bad input: exit 2, nothing on stdout, one printable line on stderr that holds `expected`.
inline void expect_refused(const CommandResult& result, const std::string& expected) {
  EXPECT_EQ(result.status, 2) << result.err;
  EXPECT_EQ(result.out, "");
  ASSERT_FALSE(result.err.empty());
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << "one line: " << result.err;
  for (const char c : result.err.substr(0, result.err.size() - 1)) {
    EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F) << result.err;
  }
  EXPECT_NE(result.err.find(expected), std::string::npos) << result.err;
}

}  // namespace scanway::test
