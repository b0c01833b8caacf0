#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>

namespace scanway::tools {

/// `scanway decode erratic`: a recorded byte stream of an ERRATIC or ERA-Mobi base, either direction or both, as JSON
/// lines on stdout: a line a packet, and one of type `bad` for each stretch that is none. Returns 0. Throws InputError
/// when the file cannot be read.
int run_decode_erratic(const std::string& file);

/// The same for bytes.
void decode_erratic(std::span<const std::uint8_t> bytes, std::ostream& out);

}  // namespace scanway::tools
