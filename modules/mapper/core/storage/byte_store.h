#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace scanway {

/// A place for bytes that are seldom needed: a map of many sweeps keeps more of them than the memory holds.
class ByteStore {
 public:
  using Ticket = std::uint64_t;

  virtual ~ByteStore() = default;
  virtual Ticket put(std::vector<std::uint8_t> bytes) = 0;
  /// `count` of the bytes that were put there, from `begin` on.
  virtual std::vector<std::uint8_t> fetch(Ticket ticket, std::size_t begin, std::size_t count) const = 0;
  virtual void drop(Ticket ticket) = 0;
};

class BytesInMemory : public ByteStore {
 public:
  Ticket put(std::vector<std::uint8_t> bytes) override {
    bytes.shrink_to_fit();
    kept_.emplace(++last_, std::move(bytes));
    return last_;
  }
  std::vector<std::uint8_t> fetch(Ticket ticket, std::size_t begin, std::size_t count) const override {
    const auto from = kept_.at(ticket).begin() + static_cast<std::ptrdiff_t>(begin);
    return {from, from + static_cast<std::ptrdiff_t>(count)};
  }
  void drop(Ticket ticket) override { kept_.erase(ticket); }

 private:
  std::map<Ticket, std::vector<std::uint8_t>> kept_;
  Ticket last_ = 0;
};

/// Bytes that stay in a store as long as this does.
class StoredBytes {
 public:
  StoredBytes(std::shared_ptr<ByteStore> store, std::vector<std::uint8_t> bytes)
      : store_(std::move(store)), size_(bytes.size()), ticket_(store_->put(std::move(bytes))) {}
  StoredBytes(StoredBytes&& other) noexcept = default;
  StoredBytes& operator=(StoredBytes&& other) noexcept {
    std::swap(store_, other.store_);
    std::swap(size_, other.size_);
    std::swap(ticket_, other.ticket_);
    return *this;
  }
  ~StoredBytes() {
    if (store_) store_->drop(ticket_);
  }

  std::vector<std::uint8_t> fetch() const { return fetch(0, size_); }
  std::vector<std::uint8_t> fetch(std::size_t begin, std::size_t end) const {
    return store_->fetch(ticket_, begin, end - begin);
  }
  std::size_t size() const { return size_; }

 private:
  std::shared_ptr<ByteStore> store_;
  std::size_t size_;
  ByteStore::Ticket ticket_;
};

}  // namespace scanway
