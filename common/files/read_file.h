#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace scanway {

/// The bytes of a regular file. Throws InputError that names the path and the reason.
std::string read_file(const std::string& path);

/// The same a part after the other, none longer than 1 MiB, for files that need not be in the memory as a whole.
void read_parts(const std::string& path, const std::function<void(std::string_view)>& take);

/// Like read_file, but a file of zstd frames (told by its content) comes decompressed. To at most 64 times its size
/// and 1 MiB: measured data does not shrink further, a file made to exhaust the memory does.
std::string read_file_decompressed(const std::string& path);

}  // namespace scanway
