#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "modules/sick_bridge/core/scan.h"
#include "tests/support/command.h"

namespace scanway::test {

inline const std::string kLmsData = std::string(SCANWAY_SHARED_DIR) + "/facts/sick/data/";

#define SKIP_WITHOUT_LMS_DATA() \
  if (!std::filesystem::exists(kLmsData)) GTEST_SKIP() << "the recorded telegrams are not at " << kLmsData

inline std::vector<std::uint8_t> lms_bytes(const std::string& name) {
  const std::string text = read_text(kLmsData + name);
  return {text.begin(), text.end()};
}

inline nlohmann::json lms_json(const std::string& name) { return nlohmann::json::parse(read_text(kLmsData + name)); }

inline std::vector<std::uint8_t> bytes_of_hex(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

/// The whole telegrams in bytes that hold nothing else.
inline std::vector<sick::Telegram> telegrams_in(const std::vector<std::uint8_t>& bytes) {
  FrameFinder finder = sick::make_frame_finder();
  finder.push(bytes);
  finder.finish();
  std::vector<sick::Telegram> telegrams;
  while (const auto stretch = finder.next()) {
    EXPECT_TRUE(stretch->whole) << stretch->reason;
    if (stretch->whole) telegrams.push_back(sick::open_frame(stretch->bytes));
  }
  return telegrams;
}

}  // namespace scanway::test
