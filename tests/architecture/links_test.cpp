// What links what: the core and the device of every bridge, and their tests, do without LCM.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

namespace scanway::architecture {
namespace {

using Targets = std::set<std::string>;

const std::map<std::string, Targets>& links() {
  static const std::map<std::string, Targets> kLinks = [] {
    std::map<std::string, Targets> all;
    std::ifstream lines(SCANWAY_LINKS_FILE);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string target, link;
      words >> target;
      for (all[target]; words >> link;) all[target].insert(link);
    }
    return all;
  }();
  return kLinks;
}

/// All that a target links, and what that links.
Targets everything_below(const std::string& target) {
  Targets found, waiting{target};
  while (!waiting.empty()) {
    const std::string next = *waiting.begin();
    waiting.erase(waiting.begin());
    if (!found.insert(next).second || !links().contains(next)) continue;
    for (const std::string& link : links().at(next)) waiting.insert(link);
  }
  return found;
}

std::string lcm_in(const std::string& target) {
  for (const std::string& link : everything_below(target)) {
    if (link.find("lcm") != link.npos) return link;
  }
  return "";
}

TEST(Links, CoreAndDeviceOfEachBridgeAndTheirTestsDoWithoutLcm) {
  for (const char* target :
       {"sick_bridge_core", "sick_bridge_device", "sick_bridge_core_test", "sick_bridge_device_test",
        "schunk_bridge_core", "schunk_bridge_device", "schunk_bridge_core_test", "schunk_bridge_can_test",
        "xsens_bridge_core", "xsens_bridge_device", "xsens_bridge_core_test", "xsens_bridge_device_test",
        "base_bridge_core", "base_bridge_device", "base_bridge_core_test", "base_bridge_device_test"}) {
    EXPECT_TRUE(links().contains(target)) << target;
    EXPECT_EQ(lcm_in(target), "") << target;
  }
}

TEST(Links, WhatDoesLinkLcmIsSeen) {
  for (const char* target : {"common_bus", "sick_bridge_node", "sick_bridge_node_test", "scanway-sick"}) {
    EXPECT_NE(lcm_in(target), "") << target;
  }
}

}  // namespace
}  // namespace scanway::architecture
