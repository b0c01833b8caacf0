#pragma once

#include <cstdint>
#include <vector>

#include "modules/mapper/core/registration/points.h"

namespace scanway::registration {

struct KeyedIndex {
  CellKey key;
  std::uint32_t index;
};

/// Sorts by key; what has the same key keeps its order. By digits from the lowest on (radix sort), over those bits
/// alone in which the cells differ: three passes for a scan, where comparing would take seventeen.
void sort_by_cell(std::vector<KeyedIndex>& entries);

}  // namespace scanway::registration
