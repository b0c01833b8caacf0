#include "modules/mapper/core/octomap/packed_brick.h"

#include <array>
#include <bit>
#include <cstring>

namespace scanway {
namespace {

using Words = std::array<std::uint64_t, kBrickWords>;
static_assert(kBrickWords == 64, "a bit a word");

/// Which words are all ones, and which hold both ones and zeros.
struct Kinds {
  std::uint64_t full = 0, mixed = 0;
};

struct Header {
  Kinds free, occupied;
};

Kinds kinds_of(const Words& words) {
  Kinds kinds;
  for (std::size_t w = 0; w < kBrickWords; ++w) {
    const std::uint64_t bit = std::uint64_t{1} << w;
    const bool full = words[w] == ~std::uint64_t{0};
    if (full) kinds.full |= bit;
    if (!full && words[w] != 0) kinds.mixed |= bit;
  }
  return kinds;
}

void append(const void* data, std::size_t size, std::vector<std::uint8_t>& bytes) {
  const auto* begin = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), begin, begin + size);
}

void append_mixed(const Words& words, const Kinds& kinds, std::vector<std::uint8_t>& bytes) {
  for (std::uint64_t left = kinds.mixed; left != 0; left &= left - 1) {
    append(&words[static_cast<std::size_t>(std::countr_zero(left))], sizeof(std::uint64_t), bytes);
  }
}

const std::uint8_t* unpack(const std::uint8_t* mixed, const Kinds& kinds, Words& words) {
  for (std::size_t w = 0; w < kBrickWords; ++w) {
    if (kinds.full >> w & 1) words[w] = ~std::uint64_t{0};
    if ((kinds.mixed >> w & 1) == 0) continue;
    std::memcpy(&words[w], mixed, sizeof(words[w]));
    mixed += sizeof(words[w]);
  }
  return mixed;
}

Header header_of(const std::uint8_t* packed) {
  Header header;
  std::memcpy(&header, packed, sizeof(header));
  return header;
}

}  // namespace

void pack(VoxelBrick brick, std::vector<std::uint8_t>& bytes) {
  brick.prefer_occupied();
  const Header header{kinds_of(brick.free), kinds_of(brick.occupied)};
  append(&header, sizeof(header), bytes);
  append_mixed(brick.free, header.free, bytes);
  append_mixed(brick.occupied, header.occupied, bytes);
}

VoxelBrick unpacked_brick(const std::uint8_t* packed) {
  const Header header = header_of(packed);
  VoxelBrick brick;
  packed = unpack(packed + sizeof(header), header.free, brick.free);
  unpack(packed, header.occupied, brick.occupied);
  return brick;
}

std::size_t packed_size(const std::uint8_t* packed) {
  const Header header = header_of(packed);
  const int mixed = std::popcount(header.free.mixed) + std::popcount(header.occupied.mixed);
  return sizeof(header) + sizeof(std::uint64_t) * static_cast<std::size_t>(mixed);
}

}  // namespace scanway
