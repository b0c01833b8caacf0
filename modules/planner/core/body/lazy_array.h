#pragma once

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
    data_.reset(static_cast<T*>(std::calloc(size_, sizeof(T))));
    if (data_ == nullptr) throw std::bad_alloc();
  }

  T& operator[](std::size_t i) { return data_.get()[i]; }
  const T& operator[](std::size_t i) const { return data_.get()[i]; }
  std::size_t size() const { return size_; }

 private:
  struct Free {
    void operator()(T* data) const { std::free(data); }
  };

  std::size_t size_;
  std::unique_ptr<T, Free> data_;
};

}  // namespace scanway::planning
