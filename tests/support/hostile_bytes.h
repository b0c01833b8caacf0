#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/bytes/frame_finder.h"
#include "common/random/random.h"

/// Streams of bytes as bad lines deliver them, for the tests of every decoder.
namespace scanway::test {

using Bytes = std::vector<std::uint8_t>;

inline Bytes random_bytes(std::size_t count, Random& random) {
  Bytes bytes(count);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  return bytes;
}

/// A frame with bytes missing, doubled or flipped, cut off, or whole.
inline Bytes damaged(Bytes frame, Random& random) {
  const auto place = [&] { return frame.begin() + static_cast<std::ptrdiff_t>(random.below(frame.size())); };
  switch (random.below(6)) {
    case 0:
      *place() ^= static_cast<std::uint8_t>(1U << random.below(8));
      break;
    case 1:
      frame.erase(place());
      break;
    case 2: {
      const auto at = place();
      frame.insert(at, std::uint8_t{*at});
      break;
    }
    case 3:
      frame.erase(place(), frame.end());
      break;
    case 4:
      *place() = static_cast<std::uint8_t>(random.below(256));
      break;
    default:
      break;
  }
  return frame;
}

/// Some frames of `good`, whole and damaged, between bytes that mean nothing.
inline Bytes hostile_stream(std::span<const Bytes> good, Random& random) {
  Bytes stream;
  const auto pieces = 1 + random.below(5);
  for (std::uint64_t i = 0; i < pieces; ++i) {
    const Bytes piece = random.below(4) == 0 ? random_bytes(random.below(60), random)
                                             : damaged(good[random.below(good.size())], random);
    stream.insert(stream.end(), piece.begin(), piece.end());
  }
  return stream;
}

/// Feeds a stream in pieces of random length; `take` gets every stretch.
template <class Take>
void feed_in_pieces(FrameFinder& finder, std::span<const std::uint8_t> stream, Random& random, const Take& take) {
  while (!stream.empty()) {
    const std::size_t count = 1 + random.below(std::min<std::size_t>(stream.size(), 200));
    finder.push(stream.first(count));
    stream = stream.subspan(count);
    while (const auto stretch = finder.next()) take(*stretch);
  }
}

}  // namespace scanway::test
