#pragma once

#include <cstddef>

namespace scanway::test {

/// Counts what operator new gives in this thread while it lives.
class Allocations {
 public:
  Allocations();
  ~Allocations();
  Allocations(const Allocations&) = delete;
  Allocations& operator=(const Allocations&) = delete;
  std::size_t bytes() const;  ///< In all, given back or not.
};

}  // namespace scanway::test
