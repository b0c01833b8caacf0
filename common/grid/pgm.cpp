#include "common/grid/pgm.h"

#include <algorithm>
#include <charconv>

#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {
namespace {

constexpr int kLongestSide = 100000;

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Reads the words of a PGM file: numbers between white space and comments.
class PgmWords {
 public:
  PgmWords(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  bool binary() {
    const std::string_view magic = bytes_.substr(0, 2);
    if (magic != "P5" && magic != "P2") fail("is no grey PGM picture (P5 or P2): convert it to one");
    at_ = 2;
    return magic == "P5";
  }

  int number(const char* what, int lowest, int highest) {
    skip_space();
    int value = 0;
    const auto [end, error] = std::from_chars(bytes_.data() + at_, bytes_.data() + bytes_.size(), value);
    if (error != std::errc{} || value < lowest || value > highest) {
      fail(std::string("has no ").append(what) + " from " + std::to_string(lowest) + " to " + std::to_string(highest) +
           " where it should stand (byte " + std::to_string(at_) + ")");
    }
    at_ = static_cast<std::size_t>(end - bytes_.data());
    return value;
  }

  /// What follows the header's single white space.
  std::string_view rest() {
    if (at_ >= bytes_.size() || !is_space(bytes_[at_])) fail("ends in its header");
    return bytes_.substr(at_ + 1);
  }

  void require_bytes(std::size_t needed) {
    const std::size_t left = bytes_.size() - std::min(bytes_.size(), at_ + 1);
    if (left >= needed) return;
    fail("is cut: " + std::to_string(needed) + " bytes of picture announced, " + std::to_string(left) + " there");
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(printable(name_) + ": " + what); }

 private:
  void skip_space() {
    while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      at_ = bytes_[at_] == '#' ? std::min(bytes_.find('\n', at_), bytes_.size()) : at_ + 1;
    }
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

void read_binary(std::string_view bytes, bool two_bytes, std::vector<std::uint16_t>& grey) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint16_t>(static_cast<unsigned char>(bytes[i])); };
  for (std::size_t i = 0; i < grey.size(); ++i) {
    grey[i] = two_bytes ? static_cast<std::uint16_t>(byte(2 * i) << 8 | byte(2 * i + 1)) : byte(i);
  }
}

}  // namespace

GreyPicture picture_from_pgm(std::string_view bytes, const std::string& name) {
  PgmWords words(bytes, name);
  GreyPicture picture;
  const bool binary = words.binary();
  picture.width = words.number("width", 1, kLongestSide);
  picture.height = words.number("height", 1, kLongestSide);
  picture.brightest = words.number("brightest grey", 1, 65535);
  const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  const bool two_bytes = picture.brightest > 255;
  words.require_bytes(binary ? pixels * (two_bytes ? 2 : 1) : 2 * pixels - 1);
  picture.grey.resize(pixels);
  if (binary) {
    read_binary(words.rest(), two_bytes, picture.grey);
    if (*std::ranges::max_element(picture.grey) > picture.brightest)
      words.fail("has a pixel brighter than its brightest grey");
  } else {
    for (std::uint16_t& grey : picture.grey)
      grey = static_cast<std::uint16_t>(words.number("grey", 0, picture.brightest));
  }
  return picture;
}

std::string pgm_from_bytes(std::int32_t width, std::int32_t height, std::string_view grey) {
  std::string pgm = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  return pgm.append(grey);
}

}  // namespace scanway
