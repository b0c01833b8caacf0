#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "modules/mapper/core/storage/byte_store.h"
#include "modules/mapper/node/nameless_file.h"

namespace scanway {

/// Bytes in a file without a name. Where the disk takes no more, they stay in memory.
class BytesOnDisk : public ByteStore {
 public:
  Ticket put(std::vector<std::uint8_t> bytes) override;
  std::vector<std::uint8_t> fetch(Ticket ticket, std::size_t begin, std::size_t count) const override;
  void drop(Ticket ticket) override;

 private:
  struct Kept {
    std::int64_t offset = 0, size = 0;
    std::vector<std::uint8_t> bytes;  ///< Only if they are not in the file.
  };

  std::int64_t take_space(std::int64_t size);
  void give_space(std::int64_t offset, std::int64_t size);

  NamelessFile file_;
  std::map<Ticket, Kept> kept_;
  std::map<std::int64_t, std::int64_t> free_;  ///< Sizes of the gaps in the file, by their offsets.
  std::int64_t end_ = 0;
  Ticket last_ = 0;
};

}  // namespace scanway
