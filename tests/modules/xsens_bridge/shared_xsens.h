#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "modules/xsens_bridge/core/message.h"
#include "tests/support/command.h"

namespace scanway::test {

inline const std::string kXsensFacts = std::string(SCANWAY_SHARED_DIR) + "/facts/xsens/";

#define SKIP_WITHOUT_XSENS_FACTS() \
  if (!std::filesystem::exists(kXsensFacts)) GTEST_SKIP() << "the recorded messages are not at " << kXsensFacts

inline nlohmann::json xsens_json(const std::string& name) {
  return nlohmann::json::parse(read_text(kXsensFacts + name));
}

inline std::vector<std::uint8_t> bytes_of_spaced_hex(const std::string& hex) {
  std::istringstream words(hex);
  std::string word;
  std::vector<std::uint8_t> bytes;
  while (words >> word) bytes.push_back(static_cast<std::uint8_t>(std::stoi(word, nullptr, 16)));
  return bytes;
}

inline nlohmann::json xsens_vectors() { return xsens_json("vectors.json")["vectors"]; }

/// One of them by its name.
inline nlohmann::json xsens_vector(const std::string& name) {
  for (const auto& vector : xsens_vectors()) {
    if (vector["name"] == name) return vector;
  }
  ADD_FAILURE() << "no vector " << name;
  return {};
}

inline xsens::Message xsens_message(const std::string& name) {
  return xsens::open_frame(bytes_of_spaced_hex(xsens_vector(name)["hex"]));
}

}  // namespace scanway::test
