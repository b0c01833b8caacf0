#include "tests/live/hostile/messages/hostile_messages.h"

#include <zstd.h>

#include <algorithm>
#include <limits>
#include <string>

#include "common/messages/codec.h"
#include "common/messages/objects.h"
#include "scanway/object_index_t.hpp"
#include "scanway/piece_request_t.hpp"
#include "tests/common/messages/random_wire.h"

namespace scanway::test {
namespace {

constexpr std::uint32_t kLengths[] = {0xFFFFFFFF, 0x10000000, 0x40000000, 0x7FFFFFFF, 0x80000000, 0xFFFF};
constexpr std::int32_t kNumbers[] = {-1,         0,          1,
                                     0x10000000, 0x40000000, std::numeric_limits<std::int32_t>::max(),
                                     2,          1000,       std::numeric_limits<std::int32_t>::min()};
constexpr std::size_t kNoise = 60'000;
constexpr std::int64_t kMaxLength = 6;

template <class T, std::size_t N>
T pick(Random& random, const T (&values)[N]) {
  return values[random.below(N)];
}

void put(Bytes& bytes, std::size_t at, std::uint64_t value, std::size_t width) {
  for (std::size_t k = 0; k < width && at + k < bytes.size(); ++k) {
    bytes[at + k] = static_cast<std::uint8_t>(value >> (8 * (width - 1 - k)));
  }
}

void append_noise(Bytes& bytes, Random& random, std::size_t size) {
  while (bytes.size() < size) bytes.push_back(static_cast<std::uint8_t>(random.next()));
}

Bytes head_of(const Layout& layout) {
  Bytes bytes(8);
  put(bytes, 0, static_cast<std::uint64_t>(layout.hash), 8);
  return bytes;
}

void hostile_lengths(const Layout& layout, Random& random, std::size_t stride, const UseBytes& use) {
  const Bytes good = random_wire(layout, random, kMaxLength);
  for (std::size_t at = 8 + random.below(stride); at < good.size(); at += stride) {
    for (const std::uint32_t length : kLengths) {
      for (const std::size_t width : {std::size_t{4}, std::size_t{2}}) {
        Bytes bytes = good;
        put(bytes, at, width == 4 ? length : length >> 16, width);
        use(bytes);
      }
    }
  }
}

void cuts(const Layout& layout, Random& random, std::size_t stride, const UseBytes& use) {
  const Bytes good = random_wire(layout, random, kMaxLength);
  for (std::size_t length = random.below(stride); length < good.size(); length += stride) {
    use({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length)});
  }
  Bytes longer = good;
  longer.push_back(0);
  use(longer);
}

void fingerprints(const Layout& layout, Random& random, const UseBytes& use) {
  for (const Layout& other : layouts()) use(random_wire(other, random, kMaxLength));
  const Bytes good = random_wire(layout, random, kMaxLength);
  for (std::size_t bit = 0; bit < 64; bit += 7) {
    Bytes bytes = good;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    use(bytes);
  }
  for (const std::uint64_t hash : {std::uint64_t{0}, ~std::uint64_t{0}}) {
    Bytes bytes = good;
    put(bytes, 0, hash, 8);
    use(bytes);
  }
}

void noise(const Layout& layout, Random& random, const UseBytes& use) {
  use({});
  use(Bytes(7, 0xFF));
  Bytes bytes;
  append_noise(bytes, random, kNoise);
  use(bytes);
  for (const std::uint8_t filler : {0x00, 0x01, 0x7F, 0xFF}) {
    bytes = head_of(layout);
    bytes.resize(kNoise, filler);
    use(bytes);
  }
  bytes = head_of(layout);
  append_noise(bytes, random, kNoise);
  use(bytes);
}

// Some keys have many versions.
std::vector<piece_t> in_pieces(const Bytes& bytes, std::int64_t number) {
  return cut(bytes, "hostile " + std::to_string(number % 50), number, 0);
}

// As many zeros as a megabyte's multiple, in a frame whose content size is `claimed`, or is not said.
Bytes bomb(std::size_t megabytes, bool says_its_size) {
  const Bytes zeros(megabytes << 20);
  ZSTD_CCtx* const context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, 19);
  ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, says_its_size ? 1 : 0);
  Bytes packed(ZSTD_compressBound(zeros.size()));
  packed.resize(ZSTD_compress2(context, packed.data(), packed.size(), zeros.data(), zeros.size()));
  ZSTD_freeCCtx(context);
  return packed;
}

void bombs(Random& random, const UsePiece& use) {
  for (const std::size_t megabytes : {std::size_t{1}, std::size_t{16}}) {
    for (const bool says_its_size : {true, false}) {
      const Bytes packed = bomb(megabytes, says_its_size);
      for (const std::size_t claimed :
           {std::size_t{1}, std::size_t{100'000}, kMaxUnpackedBytesAPiece * packed.size() / 1200, megabytes << 20}) {
        piece_t piece{};
        piece.key = "hostile bomb";
        piece.version = static_cast<std::int64_t>(random.below(1000));
        piece.digest = static_cast<std::int64_t>(random.next());
        piece.total_bytes = static_cast<std::int32_t>(std::max<std::size_t>(claimed, 1));
        piece.coding = static_cast<std::int8_t>(random.below(2));
        piece.npieces = static_cast<std::int32_t>((packed.size() + 999) / 1000);
        for (std::size_t at = 0; at < packed.size(); at += 1000, ++piece.piece) {
          const std::size_t end = std::min(packed.size(), at + 1000);
          piece.data.assign(packed.begin() + static_cast<std::ptrdiff_t>(at),
                            packed.begin() + static_cast<std::ptrdiff_t>(end));
          piece.nbytes = static_cast<std::int32_t>(piece.data.size());
          use(piece);
        }
      }
    }
  }
}

// One thing changed; `nbytes` stays the data's own length, as the encoder trusts it.
void contradict(piece_t& piece, Random& random) {
  switch (random.below(7)) {
    case 0:
      piece.npieces = pick(random, kNumbers);
      break;
    case 1:
      piece.total_bytes = pick(random, kNumbers);
      break;
    case 2:
      piece.digest = static_cast<std::int64_t>(random.next());
      break;
    case 3:
      piece.coding = static_cast<std::int8_t>(random.next());
      break;
    case 4:
      piece.piece = pick(random, kNumbers);
      break;
    case 5:
      piece.utime = static_cast<std::int64_t>(random.next());
      break;
    default:
      piece.data[random.below(piece.data.size())] ^= static_cast<std::uint8_t>(1 + random.below(255));
      piece.digest ^= 1;
  }
}

}  // namespace

void tell_lies(const Layout& layout, Random& random, std::size_t stride, const UseBytes& use) {
  const UseBytes use_lies = [&](const Bytes& bytes) {
    if (!find_fault(layout, bytes).empty()) use(bytes);  // A number in place of a number may be a good message.
  };
  hostile_lengths(layout, random, stride, use_lies);
  cuts(layout, random, stride, use_lies);
  fingerprints(layout, random, use_lies);
  noise(layout, random, use_lies);
}

void tell_lying_objects(const Channel& channel, Random& random, std::size_t stride, const UsePiece& use) {
  std::int64_t number = 0;
  tell_lies(*find_layout(channel.type), random, stride, [&](const Bytes& bytes) {
    if (bytes.empty()) return;
    for (const piece_t& piece : in_pieces(bytes, ++number)) use(piece);
  });
}

void tell_contradictions(Random& random, std::size_t rounds, const UsePiece& use) {
  Bytes object;
  append_noise(object, random, 5'000);
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto pieces = in_pieces(object, static_cast<std::int64_t>(random.below(1000)));
    piece_t piece = pieces[random.below(pieces.size())];
    contradict(piece, random);
    if (random.below(3) == 0) contradict(piece, random);
    use(piece);
  }
  bombs(random, use);
}

Bytes hostile_request(Random& random) {
  piece_request_t request{};
  request.channel = pick(random, kChannels).name;
  request.key = random.below(2) == 0 ? "index" : "map";
  request.version = static_cast<std::int64_t>(random.below(4)) - 1;
  request.digest = static_cast<std::int64_t>(random.next());
  for (std::uint64_t i = random.below(120); i > 0; --i) {
    request.first_piece.push_back(pick(random, kNumbers));
    request.end_piece.push_back(pick(random, kNumbers));
  }
  request.nranges = static_cast<std::int32_t>(request.first_piece.size());
  return encode(request);
}

Bytes hostile_index(Random& random) {
  object_index_t index{};
  index.channel = random.below(4) == 0 ? "nowhere" : std::string(pick(random, kChannels).name);
  for (std::uint64_t i = random.below(25); i > 0; --i) {
    const std::string key =
        random.below(5) == 0 ? std::string(250, 'k') : "hostile " + std::to_string(random.below(40));
    index.objects.push_back({key, static_cast<std::int64_t>(random.next()), static_cast<std::int64_t>(random.next()),
                             pick(random, kNumbers)});
  }
  index.nobjects = static_cast<std::int32_t>(index.objects.size());
  return encode(index);
}

}  // namespace scanway::test
