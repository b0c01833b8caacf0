#pragma once

#include <cstddef>
#include <string_view>

namespace scanway {

/// LZF (Marc Lehmann's LibLZF, the compression of PCD's binary_compressed): fills exactly `size` bytes at `out` from
/// `in`. False if `in` is damaged, whatever it holds: nothing outside of the two is touched.
bool lzf_decompress(std::string_view in, char* out, std::size_t size);

/// No LZF data grows by more than this: three bytes make 264.
constexpr std::size_t kLzfMaxExpansion = 88;

}  // namespace scanway
