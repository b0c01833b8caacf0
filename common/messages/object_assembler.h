#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "common/messages/objects.h"
#include "scanway/piece_t.hpp"

namespace scanway {

struct AssemblerLimits {
  std::size_t max_object_bytes = std::size_t{512} << 20;   ///< Of an object, unpacked.
  std::size_t max_waiting_bytes = std::size_t{256} << 20;  ///< Of all pieces that wait for others.
  std::size_t max_keys_remembered = 65536;                 ///< Of complete objects, to know repeated pieces.
};

/// Everything that happened to pieces and objects, since the start.
struct AssemblerCounters {
  std::uint64_t pieces = 0;              ///< All that came: kept, repeated, superseded, conflicting or bad.
  std::uint64_t kept_pieces = 0;         ///< That were new.
  std::uint64_t objects = 0;             ///< Complete, and right by their digest.
  std::uint64_t repeated_pieces = 0;     ///< Of an object that is complete, or of a piece that is there.
  std::uint64_t bad_pieces = 0;          ///< That contradict themselves or break a limit.
  std::uint64_t bad_objects = 0;         ///< Complete, but not what their digest says.
  std::uint64_t conflicting_pieces = 0;  ///< Of another object than the complete one of that key and version.
  std::uint64_t superseded_pieces = 0;   ///< Of an older version than is there.
  std::uint64_t superseded_objects = 0;  ///< Incomplete when a newer version was complete.
  std::uint64_t given_up = 0;            ///< Incomplete objects that were given up by whoever knew better.
  std::uint64_t crowded_out = 0;         ///< Incomplete objects given up because of max_waiting_bytes.
};

/// An object of which pieces are missing.
struct IncompleteObject {
  std::string key;
  std::int64_t version = 0;
  std::uint64_t digest = 0;
  Utime utime = 0;
  std::int32_t npieces = 0;
  std::vector<std::int32_t> missing;  ///< The first kMissingListed numbers that are missing, ascending.
  std::int32_t missing_count = 0;
  static constexpr std::size_t kMissingListed = 256;
};

/// Puts the objects of one channel together from their pieces, whatever order they come in, repeated, missing, mixed
/// or false. Its memory is bounded by its limits, not by what pieces say.
class ObjectAssembler {
 public:
  explicit ObjectAssembler(const AssemblerLimits& limits = {}) : limits_(limits) {}

  /// Takes a piece. Returns the object if that completes it. Of a key, versions come out in rising order and each once
  /// (as long as the key is among the max_keys_remembered that were completed last).
  std::optional<Object> add(const piece_t& piece);
  /// What waits for pieces, in the order of key and version.
  std::vector<IncompleteObject> incomplete() const;
  /// Whether this version of the key, or a newer one, came out (and is still remembered).
  bool has(const std::string& key, std::int64_t version) const;
  /// Nothing more will come of what waits: of one object, or of all. Their pieces are dropped.
  void give_up(const std::string& key, std::int64_t version, std::uint64_t digest);
  void give_up_all();
  const AssemblerCounters& counters() const { return counters_; }

 private:
  // All that the pieces of an object have in common. A false piece founds an object of its own and spoils no other.
  using Header = std::tuple<std::string, std::int64_t, std::int64_t, std::int64_t, std::int32_t, std::int8_t,
                            std::int32_t>;  // key, version, digest, utime, total_bytes, coding, npieces
  struct Parts {
    std::map<std::int32_t, std::vector<std::uint8_t>> pieces;
    std::size_t bytes = 0;      // What this counts for in waiting_bytes_.
    std::uint64_t touched = 0;  // When its last piece came.
  };
  using Waiting = std::map<Header, Parts>;
  struct Done {
    std::int64_t version;
    std::int64_t digest;
    std::uint64_t since;
  };

  bool acceptable(const piece_t& piece) const;
  bool settled(const piece_t& piece);
  Waiting::iterator keep(const piece_t& piece);
  std::optional<Object> complete(Waiting::iterator waiting);
  void remember(const Object& object);
  void drop(Waiting::iterator waiting);
  Waiting::iterator first_of(const std::string& key);
  void drop_superseded(const std::string& key, std::int64_t version);

  AssemblerLimits limits_;
  AssemblerCounters counters_;
  Waiting waiting_;
  std::map<std::uint64_t, Waiting::iterator> by_touch_;  // Least recently touched first.
  std::size_t waiting_bytes_ = 0;
  std::map<std::string, Done> done_;                 // By key: its newest complete version.
  std::map<std::uint64_t, std::string> done_since_;  // The keys of done_, least recently completed first.
};

}  // namespace scanway
