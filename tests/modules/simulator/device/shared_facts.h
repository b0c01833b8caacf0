#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/command.h"

#define SKIP_WITHOUT_FACTS() \
  if (!std::filesystem::exists(facts_path("sick"))) GTEST_SKIP() << "needs ../shared/facts, the device protocols"

namespace scanway::test {

inline std::string facts_path(const std::string& name) { return SCANWAY_SHARED_DIR "/facts/" + name; }
inline std::string facts_text(const std::string& name) { return read_text(facts_path(name)); }
inline nlohmann::json facts_json(const std::string& name) { return nlohmann::json::parse(facts_text(name)); }

/// The bytes of "FA FF 30" or "faff30".
inline std::string unhex(const std::string& hex) {
  std::string bytes, digits;
  for (const char c : hex) {
    if (c == ' ') continue;
    digits += c;
    if (digits.size() < 2) continue;
    bytes += static_cast<char>(std::stoi(digits, nullptr, 16));
    digits.clear();
  }
  return bytes;
}

inline std::string hex_of(const std::string& bytes) {
  std::string hex;
  for (const char c : bytes) {
    hex += "0123456789ABCDEF"[static_cast<unsigned char>(c) >> 4];
    hex += "0123456789ABCDEF"[c & 15];
  }
  return hex;
}

template <class Bytes>
std::string text_of(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

/// The entry of that name in a list of vectors.
inline std::string vector_named(const nlohmann::json& all, const std::string& name) {
  for (const auto& vector : all.at("vectors")) {
    if (vector.at("name") == name) return unhex(vector.at("hex"));
  }
  ADD_FAILURE() << "no vector " << name;
  return {};
}

}  // namespace scanway::test
