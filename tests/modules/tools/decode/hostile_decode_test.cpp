// Both decoders of text and bytes on random input, as a user may hand them any file.

#include <gtest/gtest.h>

#include <sstream>

#include <nlohmann/json.hpp>

#include "common/random/random.h"
#include "modules/tools/decode/decode_erratic.h"
#include "modules/tools/decode/decode_schunk.h"

namespace scanway {
namespace {

/// Every line is JSON with a type; bad ones say where and why.
void expect_lines(const std::string& text, std::uint64_t size) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const auto parsed = nlohmann::json::parse(line);
    ASSERT_TRUE(parsed.contains("type"));
    if (parsed["type"] != "bad") continue;
    ASSERT_LE(parsed["offset"].get<std::uint64_t>() + parsed["length"].get<std::uint64_t>(), size);
    ASSERT_FALSE(parsed["reason"].get<std::string>().empty());
  }
}

TEST(HostileFiles, AreDecodedToJson) {
  Random random(9);
  for (int i = 0; i < 5000; ++i) {
    std::string bytes(random.below(400), '\0');
    static constexpr std::string_view common = "\xFA\xFB\n#0123456789ABCDEF70B50B ()";
    for (auto& byte : bytes) {
      byte = random.below(4) ? common[random.below(common.size())] : static_cast<char>(random.next());
    }
    std::ostringstream schunk, erratic;
    tools::decode_schunk(bytes, schunk);
    expect_lines(schunk.str(), bytes.size());
    const std::vector<std::uint8_t> raw(bytes.begin(), bytes.end());
    tools::decode_erratic(raw, erratic);
    expect_lines(erratic.str(), bytes.size());
  }
}

}  // namespace
}  // namespace scanway
