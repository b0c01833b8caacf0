#pragma once

#include <string>

namespace scanway {

/// The bytes of a regular file. Throws InputError that names the path and the reason.
std::string read_file(const std::string& path);

/// Like read_file, but a file of zstd frames (told by its content) comes decompressed. To at most 64 times its size
/// and 1 MiB: measured data does not shrink further, a file made to exhaust the memory does.
std::string read_file_decompressed(const std::string& path);

}  // namespace scanway
