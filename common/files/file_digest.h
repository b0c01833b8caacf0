#pragma once

#include <cstdint>
#include <string>

namespace scanway {

/// XXH3-64 of a regular file's bytes, which are never in the memory as a whole. Throws InputError as read_file() does.
std::uint64_t file_digest(const std::string& path);

}  // namespace scanway
