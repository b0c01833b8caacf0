#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/bus/channels.h"
#include "common/messages/layout.h"

namespace scanway {
namespace {

/// The cells of the README's rows after "| channel |".
std::vector<std::vector<std::string>> table() {
  std::ifstream file(SCANWAY_SOURCE_DIR "/lcmtypes/README.md");
  std::vector<std::vector<std::string>> rows;
  bool within = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("| channel |"))
      within = true;
    else if (!line.starts_with("|"))
      within = false;
    else if (within && !line.starts_with("| ---")) {
      std::istringstream cells(line.substr(1));
      rows.emplace_back();
      for (std::string cell; std::getline(cells, cell, '|');) {
        const auto begin = cell.find_first_not_of(' ');
        rows.back().push_back(begin == std::string::npos ? ""
                                                         : cell.substr(begin, cell.find_last_not_of(' ') - begin + 1));
      }
    }
  }
  return rows;
}

TEST(ChannelTable, SaysTheSameAsTheCode) {
  const auto rows = table();
  ASSERT_EQ(rows.size(), std::size(kChannels));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 7U) << rows[i][0];
    EXPECT_EQ(rows[i][0], kChannels[i].name);
    EXPECT_EQ(rows[i][1], kChannels[i].type);
    EXPECT_EQ(rows[i][2], kChannels[i].cut ? "yes" : "no");
    for (const std::string& cell : rows[i]) EXPECT_FALSE(cell.empty()) << rows[i][0];
  }
}

TEST(ChannelTable, NamesOnlyTypesThatExistAndEachChannelOnce) {
  std::set<std::string_view> names;
  for (const Channel& channel : kChannels) {
    EXPECT_NE(find_layout(channel.type), nullptr) << channel.type;
    EXPECT_TRUE(names.insert(channel.name).second) << channel.name;
    EXPECT_LE(channel.name.size(), 63U);
    EXPECT_EQ(find_channel(channel.name), &channel);
  }
  EXPECT_EQ(find_channel("NO_SUCH_CHANNEL"), nullptr);
}

}  // namespace
}  // namespace scanway
