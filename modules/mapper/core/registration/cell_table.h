#pragma once

#include <cstdint>
#include <vector>

#include "modules/mapper/core/registration/points.h"

namespace scanway::registration {

/// From a cell's number to a 32-bit value: a table with open addressing that grows. Its layout never reaches a result:
/// there is no way to iterate it.
class CellTable {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  explicit CellTable(std::size_t expected = 0) {
    std::size_t slots = 64;
    while (slots < 2 * expected) slots *= 2;
    resize(slots);
  }

  /// The value of `key`, or kNone.
  std::uint32_t find(CellKey key) const {
    for (std::size_t slot = mix(key) & mask_;; slot = (slot + 1) & mask_) {
      if (slots_[slot].value == kNone) return kNone;
      if (slots_[slot].key == key) return slots_[slot].value;
    }
  }

  /// The value of `key`, which becomes `value` if the key is new.
  std::uint32_t find_or_insert(CellKey key, std::uint32_t value) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    std::size_t slot = mix(key) & mask_;
    for (; slots_[slot].value != kNone; slot = (slot + 1) & mask_) {
      if (slots_[slot].key == key) return slots_[slot].value;
    }
    slots_[slot] = {key, value};
    ++size_;
    return value;
  }

 private:
  struct Slot {
    CellKey key = 0;
    std::uint32_t value = kNone;
  };

  void resize(std::size_t slots) {
    slots_.assign(slots, Slot{});
    mask_ = slots - 1;
    size_ = 0;
  }

  void grow() {
    const std::vector<Slot> old = std::move(slots_);
    resize(2 * old.size());
    for (const Slot& slot : old) {
      if (slot.value != kNone) find_or_insert(slot.key, slot.value);
    }
  }

  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
  std::size_t size_ = 0;
};

}  // namespace scanway::registration
