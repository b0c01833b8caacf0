#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace scanway {

/// XXH3-64 of bytes: what names an object. Messages carry it as int64.
std::uint64_t digest(std::span<const std::uint8_t> bytes);

/// As 16 hexadecimal digits, the way it is shown everywhere.
std::string hex(std::uint64_t digest);
/// The same of a digest as a message carries it.
inline std::string hex(std::int64_t digest) { return hex(static_cast<std::uint64_t>(digest)); }

}  // namespace scanway
