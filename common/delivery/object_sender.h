#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/clock/steady_time.h"
#include "common/delivery/token_bucket.h"
#include "scanway/object_index_t.hpp"
#include "scanway/piece_request_t.hpp"
#include "scanway/piece_t.hpp"

namespace scanway {

struct SenderLimits {
  double bytes_per_second = 4e6;
  double burst_bytes = 16e3;
  std::size_t max_held_bytes = std::size_t{1} << 30;  ///< Of all objects that are kept for latecomers.
  std::size_t indices_a_turn = 20;                    ///< Messages of one announce().
  std::set<std::string, std::less<>> first;           ///< Channels whose objects go before all others.
  bool drop_superseded = false;                       ///< What waits of a version is not sent once there is a newer.
};

struct SenderCounters {
  std::uint64_t pieces_sent = 0;      ///< For the first time.
  std::uint64_t pieces_resent = 0;    ///< Because somebody asked.
  std::uint64_t requests = 0;         ///< That came.
  std::uint64_t requests_unmet = 0;   ///< For what is not held here (it may be held elsewhere).
  std::uint64_t objects_dropped = 0;  ///< The oldest, because of max_held_bytes.
};

/// Sends objects in pieces at a steady rate, keeps the newest version of each key, says what it holds, and sends again
/// what is asked for. Thread-safe.
class ObjectSender {
 public:
  /// Puts bytes on the bus. Called by pump() and announce() only.
  using Send = std::function<void(std::string_view channel, std::span<const std::uint8_t> bytes)>;

  explicit ObjectSender(Send send, const SenderLimits& limits = {});

  /// Takes an object's next piece, in the order in which they were cut. Without `at_once` it is only kept: whoever
  /// lacks it hears of it by announce().
  void add(std::string_view channel, const piece_t& piece, std::span<const std::uint8_t> encoded, bool at_once = true);
  void answer(const piece_request_t& request);
  /// Sends what the rate permits until `now`, what was asked for first.
  void pump(SteadyTime now);
  /// Says what is held: what is new since a few seconds each time, the rest in turns.
  void announce(SteadyTime now);

  std::size_t waiting() const;  ///< Pieces that wait to be sent.
  SenderCounters counters() const;

 private:
  using Name = std::pair<std::string, std::string>;  // Channel and key.
  struct Held {
    std::string channel;
    std::string key;
    std::int64_t version = 0;
    std::int64_t digest = 0;
    std::int64_t utime = 0;
    std::vector<std::vector<std::uint8_t>> pieces;
    std::vector<bool> queued;
    std::size_t bytes = 0;
    std::uint64_t number = 0;     // In the order of publishing.
    SteadyTime since = 0;         // When it was announced first.
    SteadyTime announced_at = 0;  // When it was announced last.
  };
  using Piece = std::pair<std::shared_ptr<Held>, std::size_t>;

  Held& hold(std::string_view channel, const piece_t& piece);
  void drop_oldest();
  bool is_superseded(const Piece& piece) const;
  void send_front(std::deque<Piece>& queue, std::uint64_t& counter);
  std::vector<object_index_t> next_indices(SteadyTime now);

  Send send_;
  SenderLimits limits_;
  mutable std::mutex mutex_;
  TokenBucket bucket_;
  SenderCounters counters_;
  std::map<Name, std::shared_ptr<Held>> held_;
  std::size_t held_bytes_ = 0;
  std::uint64_t objects_ = 0;
  std::deque<Piece> asked_;
  std::deque<Piece> fresh_;
};

}  // namespace scanway
