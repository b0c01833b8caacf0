#pragma once

#include <cstdint>

#include "common/random/random.h"

namespace scanway::simulator {

/// The random numbers of one beam: they depend on nothing but the three arguments, so that threads, thinning and the
/// order of the beams change nothing.
inline Random beam_random(std::uint64_t seed, int line, int beam) {
  const std::uint64_t line_word = static_cast<std::uint64_t>(line + 2) * 0xD1342543DE82EF95U;
  const std::uint64_t beam_word = static_cast<std::uint64_t>(beam + 2) * 0xAF251AF3B0F025B5U;
  return Random(Random(Random(seed).next() ^ line_word).next() ^ beam_word);
}

}  // namespace scanway::simulator
