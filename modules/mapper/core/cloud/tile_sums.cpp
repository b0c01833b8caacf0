#include "modules/mapper/core/cloud/tile_sums.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {

void TileSums::add(std::vector<std::uint8_t> bytes, std::uint64_t first_key, bool with_intensity) {
  bytes_.push_back(std::move(bytes));
  readers_.emplace_back(bytes_.back(), first_key, with_intensity);
}

bool TileSums::next() {
  constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t first = kNone;
  for (const SumReader& reader : readers_) first = reader.at_end() ? first : std::min(first, reader.next_key());
  if (first == kNone) return false;
  const std::uint64_t end = (cube_of(first) + 1) << kCubeBits;
  cube_.clear();
  int sweeps = 0;
  for (SumReader& reader : readers_) {
    const std::size_t before = cube_.size();
    reader.read_until(end, cube_);
    sweeps += cube_.size() > before ? 1 : 0;
  }
  if (sweeps > 1) add_up(cube_);
  return true;
}

}  // namespace scanway
