#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scanway::planning {

/// A queue of nodes in the order of key / 2^shift; within such a bucket the last one in is the first one out. Buckets
/// that hold something are found by a bitmap.
class BucketQueue {
 public:
  static constexpr std::uint64_t kNone = ~std::uint64_t{0};

  explicit BucketQueue(int shift) : shift_(shift) {}

  void push(std::uint64_t key, std::uint32_t node) {
    const std::uint64_t bucket = key >> shift_;
    if (bucket >= buckets_.size()) grow(bucket);
    std::vector<std::uint32_t>& nodes = buckets_[bucket];
    if (nodes.capacity() == 0 && !spare_.empty()) {
      nodes.swap(spare_.back());
      spare_.pop_back();
    }
    nodes.push_back(node);
    occupied_[bucket >> 6] |= std::uint64_t{1} << (bucket & 63);
    if (bucket < lowest_) lowest_ = bucket;
  }

  /// The lowest bucket that holds a node, or kNone.
  std::uint64_t lowest() {
    for (std::uint64_t word = lowest_ >> 6; word < occupied_.size(); ++word) {
      if (occupied_[word] == 0) continue;
      return lowest_ = word << 6 | static_cast<std::uint64_t>(__builtin_ctzll(occupied_[word]));
    }
    lowest_ = kNone;
    return kNone;
  }

  /// Takes out what is in a bucket, and what comes into it meanwhile: fetch(node) when it leaves, take(node) after some
  /// others have been taken, so that what it needs has come from memory by then.
  template <class Fetch, class Take>
  void empty(std::uint64_t bucket, Fetch&& fetch, Take&& take) {
    std::array<std::uint32_t, kOnTheirWay> way;
    for (std::size_t out = 0, done = 0;; ++done) {
      for (; out < done + kOnTheirWay && !buckets_[bucket].empty(); ++out) {
        way[out % kOnTheirWay] = pop(bucket);
        fetch(way[out % kOnTheirWay]);
      }
      if (done == out) return;
      take(way[done % kOnTheirWay]);
    }
  }

  std::uint64_t bucket_of(std::uint64_t key) const { return key >> shift_; }
  std::uint64_t lowest_key_of(std::uint64_t bucket) const { return bucket << shift_; }

  void clear() {
    buckets_.clear();
    occupied_.clear();
    spare_.clear();
    lowest_ = kNone;
  }

 private:
  static constexpr std::size_t kOnTheirWay = 16;

  std::uint32_t pop(std::uint64_t bucket) {
    std::vector<std::uint32_t>& nodes = buckets_[bucket];
    const std::uint32_t node = nodes.back();
    nodes.pop_back();
    if (nodes.empty()) {
      occupied_[bucket >> 6] &= ~(std::uint64_t{1} << (bucket & 63));
      spare_.emplace_back().swap(nodes);
    }
    return node;
  }

  void grow(std::uint64_t bucket) {
    const std::uint64_t size = (bucket + bucket / 4 + 64) & ~std::uint64_t{63};
    buckets_.resize(size);
    occupied_.resize(size / 64);
  }

  int shift_;
  std::uint64_t lowest_ = kNone;
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::vector<std::uint64_t> occupied_;
  std::vector<std::vector<std::uint32_t>> spare_;  ///< Memory of buckets that are empty again.
};

}  // namespace scanway::planning
