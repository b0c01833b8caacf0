#include "common/messages/objects.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <zstd.h>

#include "common/bus/memory_bus.h"
#include "common/messages/digest.h"
#include "common/messages/object_assembler.h"
#include "common/messages/sweep_message.h"
#include "common/random/random.h"
#include "scanway/octomap_t.hpp"
#include "tests/common/messages/allocations.h"

namespace scanway {
namespace {

using test::Allocations;
using Bytes = std::vector<std::uint8_t>;

Bytes random_bytes(Random& random, std::size_t n) {
  Bytes bytes(n);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
  return bytes;
}

/// An encoded sweep: what really travels.
Bytes sweep_object(Random& random, std::size_t points) {
  Sweep sweep;
  for (std::size_t i = 0; i < points; ++i) {
    sweep.cloud.points.emplace_back(static_cast<float>(random.normal()), static_cast<float>(i) * 0.01F, 1.0F);
  }
  return encode(to_message(sweep));
}

template <class T>
void shuffle(Random& random, std::vector<T>& items) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(i)]);
}

TEST(Cut, KeepsEveryPieceWithinOneFrame) {
  Random random(1);
  for (const std::size_t key_bytes : {std::size_t{0}, std::size_t{5}, kMaxKeyBytes}) {
    const auto pieces = cut(random_bytes(random, 50'000), std::string(key_bytes, 'k'), 3, 77);
    ASSERT_GT(pieces.size(), 38U);
    for (const piece_t& piece : pieces) EXPECT_LE(encode(piece).size(), kMaxPieceBytes);
    EXPECT_EQ(encode(pieces[0]).size(), kMaxPieceBytes);
  }
  EXPECT_THROW(cut(random_bytes(random, 10), std::string(kMaxKeyBytes + 1, 'k'), 3, 77), std::invalid_argument);
  EXPECT_THROW(cut({}, "key", 3, 77), std::invalid_argument);
}

TEST(Assembler, PutsPiecesTogetherInAnyOrderRepeatedAndMixed) {
  Random random(2);
  for (int round = 0; round < 30; ++round) {
    std::map<std::string, Bytes> objects;
    std::vector<piece_t> pieces;
    for (const std::string key : {"a", "b", ""}) {
      objects[key] =
          round % 2 == 0 ? sweep_object(random, 1 + random.below(3000)) : random_bytes(random, 1 + random.below(9000));
      for (const piece_t& piece : cut(objects[key], key, 5, 99)) {
        for (std::uint64_t copies = 1 + random.below(3); copies > 0; --copies) pieces.push_back(piece);
      }
    }
    shuffle(random, pieces);
    ObjectAssembler assembler;
    for (const piece_t& piece : pieces) {
      if (const auto object = assembler.add(decode<piece_t>(encode(piece)))) {
        ASSERT_EQ(object->bytes, objects.at(object->key));
        ASSERT_EQ(object->digest, digest(object->bytes));
        ASSERT_EQ(object->version, 5);
        ASSERT_EQ(object->utime, 99);
        objects.erase(object->key);
      }
    }
    EXPECT_TRUE(objects.empty());
    EXPECT_EQ(assembler.counters().objects, 3U);
    EXPECT_EQ(assembler.counters().pieces, pieces.size());
    EXPECT_TRUE(assembler.incomplete().empty());
  }
}

TEST(Assembler, NamesWhatIsMissing) {
  Random random(3);
  const Bytes object = random_bytes(random, 20'000);
  const auto pieces = cut(object, "key", 1, 0);
  ObjectAssembler assembler;
  std::vector<std::int32_t> dropped;
  for (const piece_t& piece : pieces) {
    const bool lost = random.below(3) == 0;
    if (lost) dropped.push_back(piece.piece);
    ASSERT_FALSE(!lost && assembler.add(piece));
  }
  ASSERT_FALSE(dropped.empty());
  ASSERT_EQ(assembler.incomplete().size(), 1U);
  EXPECT_EQ(assembler.incomplete()[0].missing, dropped);
  EXPECT_EQ(assembler.incomplete()[0].missing_count, static_cast<std::int32_t>(dropped.size()));
  for (const std::int32_t number : dropped) {
    const auto complete = assembler.add(pieces[static_cast<std::size_t>(number)]);
    EXPECT_EQ(complete.has_value(), number == dropped.back());
  }
}

TEST(Assembler, LetsANewerVersionReplaceAnOlder) {
  Random random(4);
  const auto old = cut(random_bytes(random, 3000), "key", 1, 0);
  const auto young = cut(random_bytes(random, 3000), "key", 2, 0);
  ObjectAssembler assembler;
  assembler.add(old[0]);
  for (const piece_t& piece : young) assembler.add(piece);
  EXPECT_EQ(assembler.counters().objects, 1U);
  EXPECT_EQ(assembler.counters().superseded_objects, 1U);
  for (const piece_t& piece : old) EXPECT_FALSE(assembler.add(piece));
  for (const piece_t& piece : young) EXPECT_FALSE(assembler.add(piece));
  EXPECT_EQ(assembler.counters().superseded_pieces, old.size());
  EXPECT_EQ(assembler.counters().repeated_pieces, young.size());
  for (const piece_t& piece : cut(random_bytes(random, 2000), "key", 2, 0)) EXPECT_FALSE(assembler.add(piece));
  EXPECT_EQ(assembler.counters().conflicting_pieces, 2U);
}

TEST(Assembler, RefusesObjectsThatAreNotWhatTheirDigestSays) {
  Random random(5);
  const Bytes object = sweep_object(random, 2000);
  const auto good = cut(object, "key", 1, 0);
  for (int round = 0; round < 300; ++round) {
    auto pieces = good;
    piece_t& piece = pieces[random.below(pieces.size())];
    piece.data[random.below(piece.data.size())] ^= static_cast<std::uint8_t>(1 + random.below(255));
    ObjectAssembler assembler;
    for (const piece_t& each : pieces) {
      // zstd may not care about the byte: then the object is what its digest says.
      const auto complete = assembler.add(each);
      ASSERT_TRUE(!complete || complete->bytes == object);
    }
    EXPECT_EQ(assembler.counters().objects + assembler.counters().bad_objects, 1U);
    if (assembler.counters().objects == 1) continue;
    for (const piece_t& each : good) assembler.add(each);  // And the right one still comes through.
    EXPECT_EQ(assembler.counters().objects, 1U);
  }
}

TEST(Assembler, SurvivesHostilePieces) {
  Random random(6);
  const auto good = cut(sweep_object(random, 1500), "key", 7, 0);
  constexpr std::int32_t kHostile[] = {-1, 0, 1, 0x10000000, 0x40000000, std::numeric_limits<std::int32_t>::max()};
  ObjectAssembler assembler;
  for (int round = 0; round < 3000; ++round) {
    piece_t piece = good[random.below(good.size())];
    const std::int32_t hostile = kHostile[random.below(std::size(kHostile))];
    const std::int32_t impossible = hostile == 0 || hostile == 1 ? -1 : hostile;  // As a number among the pieces.
    switch (random.below(6)) {
      case 0:
        piece.total_bytes = hostile;
        break;
      case 1:
        piece.npieces = hostile;
        break;
      case 2:
        piece.piece = impossible;
        break;
      case 3:
        piece.coding = static_cast<std::int8_t>(impossible);
        break;
      case 4:
        piece.nbytes = hostile;
        break;
      default:
        piece.npieces = 1, piece.piece = 0, piece.total_bytes = hostile;
    }
    const Allocations allocations;
    ASSERT_FALSE(assembler.add(piece));
    ASSERT_LT(allocations.bytes(), 64U << 10);
  }
  std::size_t completed = 0;
  for (const piece_t& piece : good) completed += assembler.add(piece) ? 1 : 0;
  EXPECT_EQ(completed, 1U);
}

TEST(Assembler, StopsABombAtItsWord) {
  const Bytes zeros(std::size_t{64} << 20);
  Bytes packed(ZSTD_compressBound(zeros.size()));
  packed.resize(ZSTD_compress(packed.data(), packed.size(), zeros.data(), zeros.size(), 19));
  for (const bool with_its_own_size : {true, false}) {
    if (!with_its_own_size) {  // A frame that does not say how much it unpacks to.
      ZSTD_CCtx* const context = ZSTD_createCCtx();
      ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
      packed.resize(ZSTD_compressBound(zeros.size()));
      packed.resize(ZSTD_compress2(context, packed.data(), packed.size(), zeros.data(), zeros.size()));
      ZSTD_freeCCtx(context);
    }
    ObjectAssembler assembler;
    piece_t piece{};
    piece.total_bytes = 100'000;
    piece.npieces = static_cast<std::int32_t>((packed.size() + 999) / 1000);
    const Allocations allocations;
    for (std::size_t at = 0; at < packed.size(); at += 1000, ++piece.piece) {
      const std::size_t end = std::min(packed.size(), at + 1000);
      piece.data.assign(packed.begin() + static_cast<std::ptrdiff_t>(at),
                        packed.begin() + static_cast<std::ptrdiff_t>(end));
      piece.nbytes = static_cast<std::int32_t>(piece.data.size());
      EXPECT_FALSE(assembler.add(piece));
    }
    EXPECT_EQ(assembler.counters().bad_objects, 1U);
    EXPECT_LT(allocations.bytes(), 1U << 20);
  }
}

// The pieces of the most that few packed bytes can pretend to be, with the digest of something else.
TEST(Assembler, ALyingObjectCostsLessThanOneMegabyteAPiece) {
  for (const std::size_t megabytes : {1, 4, 64}) {
    Bytes zeros(megabytes << 20);
    for (const bool shuffled : {true, false}) {
      const auto pieces = cut(zeros, "key", 1, 0);
      ASSERT_GE(pieces.size() * kMaxUnpackedBytesAPiece, zeros.size());
      ObjectAssembler assembler;
      std::size_t allocated = 0;
      for (piece_t piece : pieces) {
        piece.digest ^= 1;
        if (shuffled) piece.coding = piece_t::ZSTD_SHUFFLED_BY_FOUR;
        const Allocations allocations;
        EXPECT_FALSE(assembler.add(piece));
        allocated += allocations.bytes();
      }
      EXPECT_EQ(assembler.counters().bad_objects, 1U);
      EXPECT_LT(allocated, pieces.size() << 20);
    }
    ObjectAssembler assembler;  // And the honest one arrives.
    std::optional<Object> object;
    for (const piece_t& piece : cut(zeros, "key", 1, 0)) object = assembler.add(piece);
    ASSERT_TRUE(object);
    EXPECT_EQ(object->bytes, zeros);
    piece_t boast = cut(zeros, "key", 2, 0)[0];
    boast.npieces = static_cast<std::int32_t>((zeros.size() - 1) / kMaxUnpackedBytesAPiece);
    EXPECT_FALSE(assembler.add(boast));
    EXPECT_EQ(assembler.counters().bad_pieces, 1U);
  }
}

TEST(Assembler, KeepsItsMemoryBounded) {
  Random random(7);
  AssemblerLimits limits;
  limits.max_waiting_bytes = 100'000;
  limits.max_keys_remembered = 10;
  ObjectAssembler assembler(limits);
  piece_t piece{};
  piece.npieces = 2;
  piece.total_bytes = 5000;
  piece.data = random_bytes(random, 1000);
  piece.nbytes = 1000;
  for (int i = 0; i < 5000; ++i) {
    piece.key = std::to_string(i);
    EXPECT_FALSE(assembler.add(piece));
  }
  EXPECT_LE(assembler.incomplete().size(), 100U);
  EXPECT_EQ(assembler.incomplete().size() + assembler.counters().crowded_out, 5000U);
  std::size_t completed = 0;  // What is new still finds room.
  for (int i = 0; i < 50; ++i) {
    for (const piece_t& part : cut(random_bytes(random, 5000), "key" + std::to_string(i), 1, 0)) {
      completed += assembler.add(part) ? 1 : 0;
    }
  }
  EXPECT_EQ(completed, 50U);
}

TEST(PublishObject, SendsPiecesThatAreSpacedInTime) {
  Random random(8);
  const Bytes object = random_bytes(random, 5000);
  MemoryBus bus;
  ObjectAssembler assembler;
  std::vector<Utime> times;
  std::optional<Object> complete;
  bus.subscribe("OCTOMAP", [&](const BusMessage& message) {
    times.push_back(message.utime);
    if (auto object_now = assembler.add(decode<piece_t>(message.bytes))) complete = std::move(object_now);
  });
  EXPECT_EQ(publish_object(bus, channel::kOctomap, object, "map", 4, 1000, 20), digest(object));
  bus.dispatch();
  EXPECT_EQ(times, (std::vector<Utime>{1000, 1020, 1040, 1060, 1080}));
  ASSERT_TRUE(complete);
  EXPECT_EQ(complete->bytes, object);
  EXPECT_EQ(complete->utime, 1000);
}

}  // namespace
}  // namespace scanway
