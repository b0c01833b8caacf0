#include "common/files/file_digest.h"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <string>

#include "common/files/input_error.h"
#include "common/random/random.h"
#include "tests/support/command.h"

namespace scanway::test {
namespace {

TEST(FileDigest, IsThatOfAllItsBytesAtOnce) {
  const ScratchFolder scratch;
  Random random(5);
  for (const std::size_t size : {0u, 1u, 240u, 241u, 1u << 20, (1u << 20) + 1, 3'500'000u}) {
    std::string bytes;
    while (bytes.size() < size) bytes.push_back(static_cast<char>(random.below(256)));
    write_text(scratch / "file", bytes);
    EXPECT_EQ(file_digest(scratch / "file"), XXH3_64bits(bytes.data(), bytes.size())) << size;
  }
  EXPECT_THROW(file_digest(scratch / "none"), InputError);
}

}  // namespace
}  // namespace scanway::test
