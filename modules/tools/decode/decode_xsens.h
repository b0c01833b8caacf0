#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>

namespace scanway::tools {

/// `scanway decode xsens`: a recorded byte stream of an Xsens tracker (MTData2, or MTData of older ones) as JSON lines
/// on stdout: a line a message, and one of type `bad` for each stretch that is none. Returns 0. Throws InputError when
/// the file cannot be read.
int run_decode_xsens(const std::string& file);

/// The same for bytes.
void decode_xsens(std::span<const std::uint8_t> bytes, std::ostream& out);

}  // namespace scanway::tools
