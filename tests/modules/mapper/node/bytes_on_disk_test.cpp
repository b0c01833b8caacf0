#include "modules/mapper/node/bytes_on_disk.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "common/random/random.h"

namespace scanway {
namespace {

TEST(BytesOnDisk, HoldsWhatTheMemoryWould) {
  Random random(4);
  BytesOnDisk disk;
  std::map<ByteStore::Ticket, std::vector<std::uint8_t>> kept;
  for (int i = 0; i < 3000; ++i) {
    if (random.below(5) < 3 || kept.empty()) {
      std::vector<std::uint8_t> bytes(random.below(400));
      for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
      EXPECT_TRUE(kept.emplace(disk.put(bytes), bytes).second) << "a ticket that is in use";
    } else {
      const auto some = std::next(kept.begin(), static_cast<std::ptrdiff_t>(random.below(kept.size())));
      disk.drop(some->first);
      kept.erase(some);
    }
    if (i % 100 != 0) continue;
    for (const auto& [ticket, bytes] : kept) {
      ASSERT_EQ(disk.fetch(ticket, 0, bytes.size()), bytes);
      const std::size_t begin = random.below(bytes.size() + 1);
      ASSERT_EQ(disk.fetch(ticket, begin, bytes.size() - begin),
                std::vector<std::uint8_t>(bytes.begin() + static_cast<std::ptrdiff_t>(begin), bytes.end()));
    }
  }
}

}  // namespace
}  // namespace scanway
