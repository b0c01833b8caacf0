#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "common/bus/channels.h"
#include "common/messages/layout.h"
#include "common/random/random.h"
#include "scanway/piece_t.hpp"

namespace scanway::test {

using Bytes = std::vector<std::uint8_t>;
using UseBytes = std::function<void(const Bytes&)>;
using UsePiece = std::function<void(const piece_t&)>;

/// What is not a message of that layout but looks like one: hostile lengths anywhere, nested ones included, messages
/// cut at every place or continued, other types' and nobody's fingerprints, 60 kB of noise. Of the lies that are alike
/// only every `stride`-th is told.
void tell_lies(const Layout& layout, Random& random, std::size_t stride, const UseBytes& use);

/// Objects of a channel whose pieces are good and whose content is a lie.
void tell_lying_objects(const Channel& channel, Random& random, std::size_t stride, const UsePiece& use);

/// Pieces that contradict each other or themselves, and none of whose objects can become whole; bombs that unpack to
/// more than they say, and those whose digest is another's.
void tell_contradictions(Random& random, std::size_t rounds, const UsePiece& use);

/// Requests for, and announcements of, what cannot be: encoded, at most as long as a message may be.
Bytes hostile_request(Random& random);
Bytes hostile_index(Random& random);

}  // namespace scanway::test
