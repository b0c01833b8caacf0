#pragma once

#include <cstddef>
#include <cstdint>

namespace scanway::registration {

/// Floats that are computed side by side: one AVX2 register, or two of SSE. Lanes never mix, so every width of vector
/// instructions gives the same bits. For code with `target_clones`; no argument and no result of a function.
constexpr std::size_t kLanes = 8;
typedef float Lanes __attribute__((vector_size(kLanes * sizeof(float)), aligned(sizeof(float)), may_alias));
typedef std::uint32_t Indices
    __attribute__((vector_size(kLanes * sizeof(std::uint32_t)), aligned(sizeof(float)), may_alias));

}  // namespace scanway::registration
