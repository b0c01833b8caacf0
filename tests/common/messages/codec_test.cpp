#include "common/messages/codec.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "common/messages/digest.h"
#include "common/random/random.h"
#include "lcmtypes/all_types.h"
#include "tests/common/messages/allocations.h"
#include "tests/common/messages/random_wire.h"

namespace scanway {
namespace {

using test::Allocations;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kFewKilobytes = 4096;

template <class T>
class EveryType : public testing::Test {};

template <class... T>
struct DropFirst;
template <class First, class... T>
struct DropFirst<First, T...> {
  using Types = testing::Types<T...>;
};
#define SCANWAY_COMMA_TYPE(T) , T
using AllTypes = DropFirst<void LCMTYPES_FOR_EACH(SCANWAY_COMMA_TYPE)>::Types;
TYPED_TEST_SUITE(EveryType, AllTypes);

template <class T>
const Layout& layout_of() {
  return *find_layout(T::getHash());
}

/// Refused with a reason and without memory, or decoded to exactly these bytes. (Returns whether it was accepted.)
template <class T>
bool refused_or_right(const Bytes& bytes) {
  std::string reason;
  std::size_t allocated = 0;
  {
    const Allocations allocations;
    try {
      check_message(T::getHash(), bytes);
    } catch (const BadMessage& bad) {
      reason = bad.what();
    }
    allocated = allocations.bytes();
  }
  EXPECT_LT(allocated, kFewKilobytes);
  if (!reason.empty()) return false;
  const Allocations allocations;
  const T message = decode<T>(bytes);
  EXPECT_LT(allocations.bytes(), kFewKilobytes + 32 * bytes.size());  // A string of 5 bytes is an object of 32.
  EXPECT_EQ(encode(message), bytes);
  return true;
}

TYPED_TEST(EveryType, HasTheLayoutThatItsTextSays) {
  // The layout's fingerprint is computed from the .lcm text, the type's by lcm-gen: a member that one of them does not
  // know makes them differ.
  const auto all = layouts();
  const auto found =
      std::find_if(all.begin(), all.end(), [](const Layout& layout) { return layout.hash == TypeParam::getHash(); });
  ASSERT_NE(found, all.end());
  EXPECT_TRUE(found->name.ends_with(std::string(".") + TypeParam::getTypeName()));
}

TYPED_TEST(EveryType, RoundTrips) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Bytes bytes = test::random_wire(layout_of<TypeParam>(), random, i < 20 ? 0 : 9);
    ASSERT_EQ(find_fault(layout_of<TypeParam>(), bytes), "");
    ASSERT_TRUE(refused_or_right<TypeParam>(bytes));
  }
}

TYPED_TEST(EveryType, RefusesAMessageThatIsCutOrContinued) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    Bytes bytes = test::random_wire(layout_of<TypeParam>(), random, 5);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      ASSERT_FALSE(
          refused_or_right<TypeParam>(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length))));
    }
    bytes.push_back(0);
    ASSERT_FALSE(refused_or_right<TypeParam>(bytes));
  }
}

TYPED_TEST(EveryType, RefusesEveryOtherFingerprint) {
  Random random(3);
  Bytes bytes = test::random_wire(layout_of<TypeParam>(), random, 5);
  for (std::size_t bit = 0; bit < 64; ++bit) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    ASSERT_FALSE(refused_or_right<TypeParam>(bytes));
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
  }
}

TYPED_TEST(EveryType, IsNotFooledByAHostileLengthAnywhere) {
  Random random(4);
  constexpr std::uint32_t kHostile[] = {0xFFFFFFFF, 0x80000000, 0x10000000, 0x40000000, 0x7FFFFFFF, 0, 1, 1000};
  for (int i = 0; i < 10; ++i) {
    const Bytes good = test::random_wire(layout_of<TypeParam>(), random, 6);
    for (std::size_t at = 8; at + 2 <= good.size(); ++at) {
      for (const std::uint32_t hostile : kHostile) {
        Bytes bytes = good;
        for (std::size_t k = 0; k < 4 && at + k < bytes.size(); ++k) {
          bytes[at + k] = static_cast<std::uint8_t>(hostile >> (24 - 8 * k));
        }
        refused_or_right<TypeParam>(bytes);
        bytes = good;  // And as a length of two bytes.
        bytes[at] = static_cast<std::uint8_t>(hostile >> 24);
        bytes[at + 1] = static_cast<std::uint8_t>(hostile >> 16);
        refused_or_right<TypeParam>(bytes);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TYPED_TEST(EveryType, SurvivesRandomBytes) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    Bytes bytes = test::random_wire(layout_of<TypeParam>(), random, 6);
    const std::uint64_t changes = 1 + random.below(4);
    for (std::uint64_t k = 0; k < changes && bytes.size() > 8; ++k) {
      bytes[8 + random.below(bytes.size() - 8)] = static_cast<std::uint8_t>(random.next());
    }
    if (random.below(2) == 0) bytes.resize(8 + random.below(bytes.size()));
    refused_or_right<TypeParam>(bytes);
    if (testing::Test::HasFailure()) return;
  }
}

Bytes bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

TEST(Codec, SaysWhatIsWrongAndWhere) {
  sweep_inputs_t message{};
  message.ninputs = 2;
  message.inputs.resize(2);
  message.inputs[1].channel = "IMU";
  Bytes bytes = encode(message);
  const Bytes imu = bytes_of("IMU");
  const auto at = std::search(bytes.begin(), bytes.end(), imu.begin(), imu.end());
  *(at - 4) = 0x40;
  EXPECT_EQ(find_fault(*find_layout("scanway.sweep_inputs_t"), bytes),
            "scanway.input_span_t.channel: length 1073741828, but only 44 bytes follow");
  try {
    decode<goal_t>(encode(message));
    FAIL();
  } catch (const BadMessage& bad) {
    EXPECT_STREQ(bad.what(), "not scanway.goal_t but scanway.sweep_inputs_t");
  }
}

TEST(Codec, RefusesStringsThatHideBytes) {
  goal_t goal{};
  params_t params{};
  params.robot_yaml = "name: a";
  Bytes bytes = encode(params);
  bytes[bytes.size() - 3] = 0;
  EXPECT_THROW(decode<params_t>(bytes), BadMessage);
  params.robot_yaml[2] = '\0';
  EXPECT_THROW(encode(params), std::invalid_argument);
  EXPECT_NO_THROW(decode<goal_t>(encode(goal)));
}

TEST(Layouts, HaveFingerprintsOfTheirOwn) {
  const auto all = layouts();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(all[i].hash, all[j].hash) << all[i].name << " and " << all[j].name;
  }
}

}  // namespace
}  // namespace scanway
