#include "tests/modules/xsens_bridge/hostile_xsens.h"

namespace scanway::test {

TEST(XsensSoak, HostileStreams) { try_hostile_streams(xsens_trial(), 1'000'000, 21); }

TEST(XsensSoak, RandomStreams) { try_random_streams(xsens_trial(), 1'000'000, 22); }

}  // namespace scanway::test
