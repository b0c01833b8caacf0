#include "tests/modules/sick_bridge/hostile_lms.h"

namespace scanway::test {

TEST(LmsSoak, HostileStreams) { try_hostile_streams(lms_trial(), 1'000'000, 11); }

TEST(LmsSoak, RandomStreams) { try_random_streams(lms_trial(), 1'000'000, 12); }

}  // namespace scanway::test
