#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scanway::registration {

/// Which of n matches are compatible with which: a symmetric matrix of bits, 64 to a word.
class Compatibility {
 public:
  explicit Compatibility(std::size_t n) : size_(n), words_((n + 63) / 64), bits_(n * words_, 0) {}
  std::size_t size() const { return size_; }
  bool test(std::size_t i, std::size_t j) const { return row(i)[j / 64] >> (j % 64) & 1u; }
  /// Writes to row i alone.
  void set(std::size_t i, std::size_t j) { row(i)[j / 64] |= std::uint64_t{1} << (j % 64); }
  /// Makes what was set above the diagonal hold below it.
  void mirror();
  /// How many others both are compatible with.
  std::size_t common(std::size_t i, std::size_t j) const;

 private:
  std::uint64_t* row(std::size_t i) { return bits_.data() + i * words_; }
  const std::uint64_t* row(std::size_t i) const { return bits_.data() + i * words_; }

  std::size_t size_, words_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace scanway::registration
