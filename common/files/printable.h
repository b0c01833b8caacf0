#pragma once

#include <string>
#include <string_view>

namespace scanway {

/// `text` as it may be shown on a terminal: printable ASCII and well-formed UTF-8 as they are, every other byte escaped
/// (\n, \t, \r, else \x1B). Control characters of Unicode that change how the rest of a line looks are escaped too.
/// Escaping twice changes nothing more.
std::string printable(std::string_view text);

/// A piece of input for an error message: printable, in single quotes, cut after 40 bytes.
std::string in_quotes(std::string_view text);

}  // namespace scanway
