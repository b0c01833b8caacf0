#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <tbb/parallel_for.h>

namespace scanway {

/// Calls body(begin, end, block_index) for the fixed blocks of [0, n). The blocks depend on n and `block` alone, never
/// on the number of threads, so whatever is computed a block at a time is the same for every number of threads.
/// (A program sets its number of threads once, with tbb::global_control.)
template <class Body>
void for_blocks(std::size_t n, std::size_t block, const Body& body) {
  const std::size_t blocks = (n + block - 1) / block;
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) { body(b * block, std::min(n, (b + 1) * block), b); });
}

/// The sum of value(begin, end) over the fixed blocks of [0, n), added in index order: the same bits for every number
/// of threads. `Sum` needs a copy constructor and +=.
template <class Sum, class Value>
Sum sum_blocks(std::size_t n, std::size_t block, Sum zero, const Value& value) {
  std::vector<Sum> partial((n + block - 1) / block, zero);
  for_blocks(n, block, [&](std::size_t begin, std::size_t end, std::size_t b) { partial[b] = value(begin, end); });
  Sum total = zero;
  for (const Sum& part : partial) total += part;
  return total;
}

}  // namespace scanway
