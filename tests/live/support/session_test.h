#pragma once

#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "tests/live/support/session.h"

namespace scanway::test {

/// Processes over the short log, whose end must be what one process makes of it.
class SessionTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!namespaces_permitted()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  }
  /// Of what has versions: the newest.
  static std::string newest(const std::string& lines) {
    const std::size_t end = lines.find_last_not_of('\n');
    return end == std::string::npos ? "" : lines.substr(lines.rfind('\n', end) + 1);
  }
  void expect_same_end_as_replay() const {
    for (const char* product : {"COST_MAP_INDEX index", "OCTOMAP map", "PATH point", "PATH footprint"}) {
      EXPECT_EQ(newest(session_.observed(product)), newest(lines_of(ShortLog::get().products, product))) << product;
    }
    EXPECT_EQ(session_.observed("COST_MAP_TILE"), lines_of(ShortLog::get().products, "COST_MAP_TILE"));
    if (HasFailure()) std::puts(session_.told().c_str());
  }

  const Session session_;
};

}  // namespace scanway::test
