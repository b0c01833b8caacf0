#include "common/cloud/lzf.h"

#include <cstdint>
#include <cstring>

namespace scanway {
namespace {

/// Copies what was written `distance` bytes before `to`; the two may overlap, and then the bytes repeat.
void copy_back(char* to, std::size_t distance, std::size_t length) {
  if (distance >= length) {
    std::memcpy(to, to - distance, length);
  } else {
    for (std::size_t i = 0; i < length; ++i) to[i] = to[i - distance];
  }
}

}  // namespace

bool lzf_decompress(std::string_view in, char* out, std::size_t size) {
  std::size_t read = 0;
  std::size_t written = 0;
  const auto byte = [&] { return static_cast<std::uint8_t>(in[read++]); };
  while (read < in.size()) {
    const std::size_t control = byte();
    if (control < 32) {  // 000LLLLL: L + 1 bytes as they are.
      const std::size_t length = control + 1;
      if (in.size() - read < length || size - written < length) return false;
      std::memcpy(out + written, in.data() + read, length);
      read += length;
      written += length;
      continue;
    }
    std::size_t length = (control >> 5) + 2;  // LLLooooo oooooooo, or 111ooooo LLLLLLLL oooooooo.
    if (in.size() - read < (control >= 224 ? 2u : 1u)) return false;
    if (control >= 224) length += byte();
    const std::size_t distance = ((control & 31) << 8) + byte() + 1;
    if (distance > written || size - written < length) return false;
    copy_back(out + written, distance, length);
    written += length;
  }
  return written == size;
}

}  // namespace scanway
