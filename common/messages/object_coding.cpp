#include "common/messages/object_coding.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include <zstd.h>

#include "common/messages/layout.h"
#include "scanway/piece_t.hpp"

namespace scanway {

namespace {

constexpr int kLevel = 3;
constexpr int kWindowLog = 20;

// Planes of first, second, third and fourth bytes: what is alike in numbers of four bytes (sign, exponent) comes
// together, and zstd finds it. What is left over at the end stays as it is.
std::vector<std::uint8_t> shuffle(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> planes(bytes.begin(), bytes.end());
  const std::size_t n = bytes.size() / 4;
  for (std::size_t plane = 0; plane < 4; ++plane) {
    for (std::size_t i = 0; i < n; ++i) planes[plane * n + i] = bytes[4 * i + plane];
  }
  return planes;
}

std::vector<std::uint8_t> unshuffle(std::span<const std::uint8_t> planes) {
  std::vector<std::uint8_t> bytes(planes.begin(), planes.end());
  const std::size_t n = bytes.size() / 4;
  for (std::size_t plane = 0; plane < 4; ++plane) {
    for (std::size_t i = 0; i < n; ++i) bytes[4 * i + plane] = planes[plane * n + i];
  }
  return bytes;
}

// Whether a message of this kind holds arrays of four-byte numbers.
bool shuffle_pays(const Layout& layout) {
  return std::any_of(layout.members.begin(), layout.members.end(), [](const Layout::Member& member) {
    if (member.dimensions.empty()) return member.nested != nullptr && shuffle_pays(*member.nested);
    return member.kind == Layout::Kind::float32 || member.kind == Layout::Kind::int32;
  });
}

bool shuffle_pays(std::span<const std::uint8_t> object) {
  const Layout* const layout = find_layout(fingerprint(object));
  return layout != nullptr && shuffle_pays(*layout);
}

std::vector<std::uint8_t> compress(std::span<const std::uint8_t> bytes) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
  if (context == nullptr) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_windowLog, kWindowLog);
  std::vector<std::uint8_t> packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress2(context.get(), packed.data(), packed.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size)) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

// At once, not as a stream: that would take a window of its own beside the object.
std::optional<std::vector<std::uint8_t>> decompress(std::span<const std::uint8_t> packed, std::size_t total_bytes) {
  if (ZSTD_getFrameContentSize(packed.data(), packed.size()) != total_bytes) return std::nullopt;
  if (ZSTD_findFrameCompressedSize(packed.data(), packed.size()) != packed.size()) return std::nullopt;
  std::vector<std::uint8_t> bytes(total_bytes);
  const std::size_t size = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(size) || size != total_bytes) return std::nullopt;
  return bytes;
}

}  // namespace

Packed pack(std::span<const std::uint8_t> object) {
  if (shuffle_pays(object)) return {piece_t::ZSTD_SHUFFLED_BY_FOUR, compress(shuffle(object))};
  return {piece_t::ZSTD, compress(object)};
}

std::optional<std::vector<std::uint8_t>> unpack(const Packed& packed, std::size_t total_bytes) {
  auto bytes = decompress(packed.bytes, total_bytes);
  if (bytes && packed.coding == piece_t::ZSTD_SHUFFLED_BY_FOUR) *bytes = unshuffle(*bytes);
  return bytes;
}

}  // namespace scanway
