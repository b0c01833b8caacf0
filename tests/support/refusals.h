#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/command.h"

namespace scanway::test {

/// Options that a program cannot use, and what its one line says of them.
struct Refusal {
  std::vector<std::string> options;
  std::string line;
};

/// The program ends with status 2 and one line that holds `line`, for each.
inline void expect_refusals(const std::string& program, const std::vector<Refusal>& refusals) {
  for (const auto& [options, line] : refusals) {
    std::vector<std::string> words = {program};
    words.insert(words.end(), options.begin(), options.end());
    const auto refused = run_command(words);
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_NE(refused.err.find(line), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
}

}  // namespace scanway::test
