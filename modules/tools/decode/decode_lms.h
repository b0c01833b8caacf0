#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>

namespace scanway::tools {

/// `scanway decode lms`: a recorded byte stream of an LMS5xx (CoLa-A or CoLa-B, found out by itself) as JSON lines on
/// stdout: a line a telegram, and one of type `bad` for each stretch that is none. Returns 0. Throws InputError when
/// the file cannot be read.
int run_decode_lms(const std::string& file);

/// The same for bytes.
void decode_lms(std::span<const std::uint8_t> bytes, std::ostream& out);

}  // namespace scanway::tools
