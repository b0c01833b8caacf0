#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scanway {

/// A grey picture, row by row from its top.
struct GreyPicture {
  std::int32_t width = 0;
  std::int32_t height = 0;
  int brightest = 255;  ///< The grey that stands for white, at most 65535.
  std::vector<std::uint16_t> grey;
};

/// The picture of a PGM file's bytes (P5 or P2; netpbm's pgm(5)). `name` stands for the file in messages. Nothing is
/// allocated that the file's size does not bear out. Throws InputError.
GreyPicture picture_from_pgm(std::string_view bytes, const std::string& name);

/// A binary PGM of 8 bits a pixel, row by row from the top.
std::string pgm_from_bytes(std::int32_t width, std::int32_t height, std::string_view grey);

}  // namespace scanway
