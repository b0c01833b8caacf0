#include "tests/common/messages/allocations.h"

#include <cstdlib>
#include <new>

namespace {

thread_local bool counting = false;
thread_local std::size_t counted = 0;

}  // namespace

void* operator new(std::size_t size) {
  if (counting) counted += size;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace scanway::test {

Allocations::Allocations() {
  counted = 0;
  counting = true;
}
Allocations::~Allocations() { counting = false; }
std::size_t Allocations::bytes() const { return counted; }

}  // namespace scanway::test
