#pragma once

#include <cstddef>

namespace scanway::test {

/// What this thread allocates while it lives, by whatever means (malloc too). Needs the address sanitizer.
class AllocationMeter {
 public:
  AllocationMeter();
  ~AllocationMeter();
  AllocationMeter(const AllocationMeter&) = delete;
  AllocationMeter& operator=(const AllocationMeter&) = delete;

  std::size_t bytes() const;  ///< In all, given back or not.
};

}  // namespace scanway::test
