#include "tests/live/hostile/allocation_meter.h"

namespace {

thread_local bool counting = false;
thread_local std::size_t counted = 0;

void note(const volatile void*, std::size_t size) {
  if (counting) counted += size;
}
void ignore(const volatile void*) {}

}  // namespace

// Of the sanitizer's run-time library; GCC 12 has no header for it.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*malloc_hook)(const volatile void*, std::size_t),
                                                         void (*free_hook)(const volatile void*));

namespace scanway::test {

AllocationMeter::AllocationMeter() {
  static const int kInstalled = __sanitizer_install_malloc_and_free_hooks(note, ignore);
  counted = 0;
  counting = kInstalled != 0;
}
AllocationMeter::~AllocationMeter() { counting = false; }
std::size_t AllocationMeter::bytes() const { return counted; }

}  // namespace scanway::test
