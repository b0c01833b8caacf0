#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

namespace scanway::tools {

/// `scanway decode schunk`: a recording of a CAN bus as JSON lines on stdout: a line a message of the SCHUNK Motion
/// Protocol (fragments put together) or other frame, and one of type `bad` for what is none. The recording is text, a
/// frame a line: candump's log (candump -L, -l), candump's screen output, cansend's form, or a CSV with columns can_id
/// and data, beginning with a line of names. Returns 0. Throws InputError when the file cannot be read.
int run_decode_schunk(const std::string& file);

/// The same for text.
void decode_schunk(std::string_view text, std::ostream& out);

}  // namespace scanway::tools
