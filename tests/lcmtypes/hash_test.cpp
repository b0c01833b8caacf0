#include <cstdint>

#include <gtest/gtest.h>

#include "bot_core/ins_t.hpp"
#include "bot_core/joint_state_t.hpp"
#include "bot_core/planar_lidar_t.hpp"
#include "bot_core/pose_t.hpp"
#include "bot_core/raw_t.hpp"
#include "bot_core/rigid_transform_t.hpp"

namespace {

std::uint64_t bits(std::int64_t hash) { return static_cast<std::uint64_t>(hash); }

// The fingerprints of libbot2's and openhumanoids' own .lcm files: whoever knows those types can read our logs.
TEST(BotCore, HasTheFingerprintsThatLcmUsersHave) {
  EXPECT_EQ(bits(bot_core::planar_lidar_t::getHash()), 0xe3d17423180b5e8dU);
  EXPECT_EQ(bits(bot_core::pose_t::getHash()), 0x2e16efb052b0105eU);
  EXPECT_EQ(bits(bot_core::ins_t::getHash()), 0x88a7df61422b0840U);
  EXPECT_EQ(bits(bot_core::joint_state_t::getHash()), 0x3e377b4cebc593a4U);
  EXPECT_EQ(bits(bot_core::rigid_transform_t::getHash()), 0xea9ffbf2acc5c5aeU);
  EXPECT_EQ(bits(bot_core::raw_t::getHash()), 0x30571b45b804c18eU);
}

}  // namespace
