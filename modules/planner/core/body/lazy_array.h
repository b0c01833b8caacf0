#pragma once

#include <sys/mman.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace scanway::planning {

/// An array of zeros. Memory that is never touched costs nothing: the system hands out its pages on first use.
template <class T>
class LazyArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  explicit LazyArray(std::size_t size) : size_(size) { clear(); }

  /// All zeros again.
  void clear() {
    data_.reset();
    if (size_ == 0) return;
    void* const fresh =
        ::mmap(nullptr, size_ * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (fresh == MAP_FAILED) throw std::bad_alloc();
    data_ = std::unique_ptr<T, Free>(static_cast<T*>(fresh), Free{size_ * sizeof(T)});
  }

  T& operator[](std::size_t i) { return data_.get()[i]; }
  const T& operator[](std::size_t i) const { return data_.get()[i]; }
  std::size_t size() const { return size_; }

 private:
  struct Free {
    std::size_t bytes = 0;
    void operator()(T* data) const { ::munmap(data, bytes); }
  };

  std::size_t size_;
  std::unique_ptr<T, Free> data_;
};

}  // namespace scanway::planning
