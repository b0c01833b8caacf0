#include "common/messages/lcm_text.h"

#include <gtest/gtest.h>

namespace scanway {
namespace {

TEST(LcmText, ReadsWhatTheGrammarAllows) {
  const auto layouts = parse_lcm_text(
      "/* a\n comment */ package p; // another\nstruct a_t { int32_t n, m; const int8_t K = 3, L = 0x4;\n"
      "  float f[n][3] ; other.b_t b[m]; c_t c; }\nstruct c_t{string s[0x10];}");
  ASSERT_EQ(layouts.size(), 2U);
  EXPECT_EQ(layouts[0].name, "p.a_t");
  ASSERT_EQ(layouts[0].members.size(), 5U);
  EXPECT_EQ(layouts[0].members[2].dimensions[0].length_member, 0);
  EXPECT_EQ(layouts[0].members[2].dimensions[1].size, 3);
  EXPECT_EQ(layouts[0].members[3].type, "other.b_t");
  EXPECT_EQ(layouts[0].members[4].type, "p.c_t");
  EXPECT_EQ(layouts[1].members[0].dimensions[0].size, 16);
}

TEST(LcmText, RefusesWhatItCannotKnow) {
  for (const char* text :
       {"struct", "struct a_t { int32_t n; ", "struct a_t { float f[n]; }", "pack a;", "struct a_t { int32_t n }"}) {
    EXPECT_THROW(parse_lcm_text(text), std::invalid_argument) << text;
  }
  auto unknown = parse_lcm_text("package p; struct a_t { b_t b; }");
  EXPECT_THROW(link_nested(unknown), std::invalid_argument);
  auto endless = parse_lcm_text("package p; struct a_t { a_t a; }");
  EXPECT_THROW(link_nested(endless), std::invalid_argument);
}

}  // namespace
}  // namespace scanway
