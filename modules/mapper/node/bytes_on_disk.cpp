#include "modules/mapper/node/bytes_on_disk.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace scanway {

ByteStore::Ticket BytesOnDisk::put(std::vector<std::uint8_t> bytes) {
  const auto size = static_cast<std::int64_t>(bytes.size());
  Kept kept{take_space(size), size, {}};
  if (!file_.write(bytes, kept.offset)) kept.bytes = std::move(bytes);
  kept_.emplace(++last_, std::move(kept));
  return last_;
}

std::vector<std::uint8_t> BytesOnDisk::fetch(Ticket ticket, std::size_t begin, std::size_t count) const {
  const Kept& kept = kept_.at(ticket);
  std::vector<std::uint8_t> bytes(count);
  if (kept.bytes.empty()) {
    file_.read(bytes, kept.offset + static_cast<std::int64_t>(begin));
  } else {
    std::copy_n(kept.bytes.begin() + static_cast<std::ptrdiff_t>(begin), count, bytes.begin());
  }
  return bytes;
}

void BytesOnDisk::drop(Ticket ticket) {
  const auto kept = kept_.find(ticket);
  give_space(kept->second.offset, kept->second.size);
  kept_.erase(kept);
}

/// The first gap that is wide enough, or the file's end.
std::int64_t BytesOnDisk::take_space(std::int64_t size) {
  const auto gap = std::find_if(free_.begin(), free_.end(), [size](const auto& g) { return g.second >= size; });
  if (gap == free_.end()) return std::exchange(end_, end_ + size);
  const auto [offset, width] = *gap;
  free_.erase(gap);
  if (width > size) free_.emplace(offset + size, width - size);
  return offset;
}

/// Gaps that touch become one.
void BytesOnDisk::give_space(std::int64_t offset, std::int64_t size) {
  if (size == 0) return;
  const auto after = free_.find(offset + size);
  if (after != free_.end()) {
    size += after->second;
    free_.erase(after);
  }
  const auto next = free_.lower_bound(offset);
  if (next != free_.begin() && std::prev(next)->first + std::prev(next)->second == offset) {
    std::prev(next)->second += size;
  } else {
    free_.emplace(offset, size);
  }
}

}  // namespace scanway
