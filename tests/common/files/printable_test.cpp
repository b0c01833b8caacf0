#include "common/files/printable.h"

#include <gtest/gtest.h>

namespace scanway {
namespace {

using namespace std::string_literals;

TEST(Printable, KeepsTextOfAnyLanguage) {
  EXPECT_EQ(printable("a/scan 000.pcd"), "a/scan 000.pcd");
  EXPECT_EQ(printable("Größe Ξάνθη 点 \xF0\x9F\xA4\x96"), "Größe Ξάνθη 点 \xF0\x9F\xA4\x96");
}

TEST(Printable, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(printable("\x1B[31mred\x07\n\r\t\x7F"), "\\x1B[31mred\\x07\\n\\r\\t\\x7F");
  EXPECT_EQ(printable("zero\0byte"s), "zero\\x00byte");
  EXPECT_EQ(printable("\xC2\x9B"), "\\xC2\\x9B");           // U+009B, the one-byte ESC [ of terminals.
  EXPECT_EQ(printable("\xE2\x80\xAE"), "\\xE2\\x80\\xAE");  // U+202E, which turns the rest of the line around.
}

TEST(Printable, EscapesWhatIsNotUtf8) {
  EXPECT_EQ(printable("\xFF"), "\\xFF");
  EXPECT_EQ(printable("\xC0\xAF"), "\\xC0\\xAF");                    // Overlong '/'.
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xED\\xA0\\x80");           // A surrogate.
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xF4\\x90\\x80\\x80");  // Above U+10FFFF.
  EXPECT_EQ(printable("\xE2\x82"), "\\xE2\\x82");                    // Cut.
}

TEST(Printable, GivesTheSameWhenAppliedTwice) {
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      const std::string text = {static_cast<char>(first), static_cast<char>(second), 'x'};
      const std::string once = printable(text);
      EXPECT_EQ(printable(once), once);
      for (const char c : once) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
    }
  }
}

TEST(Quoted, CutsWhatIsLong) {
  EXPECT_EQ(in_quotes("abc"), "'abc'");
  EXPECT_EQ(in_quotes(std::string(1000, 'a')), "'" + std::string(40, 'a') + "...'");
}

}  // namespace
}  // namespace scanway
