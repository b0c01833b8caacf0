#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/clock/steady_time.h"
#include "common/messages/object_assembler.h"
#include "scanway/object_index_t.hpp"
#include "scanway/piece_request_t.hpp"
#include "scanway/piece_t.hpp"

namespace scanway {

struct ReceiverLimits {
  AssemblerLimits assembler;                 ///< Of each channel.
  SteadyTime quiet = 150'000;                ///< An object is asked for when none of its pieces came for so long.
  SteadyTime first_interval = 250'000;       ///< Between two requests for an object; doubles while nothing comes,
  SteadyTime longest_interval = 2'000'000;   ///< up to this.
  SteadyTime give_up_after = 60'000'000;     ///< Since anything was heard of the object: a piece or an announcement.
  std::size_t max_wanted = 65536;            ///< Objects; more are not taken note of until some are complete.
  std::size_t requests_a_turn = 50;          ///< Of one ask().
  std::set<std::string, std::less<>> first;  ///< Channels whose objects are asked for before all others.
};

struct ReceiverCounters {
  std::uint64_t requests = 0;  ///< That were sent.
  std::uint64_t repaired = 0;  ///< Pieces that came after they were asked for.
  std::uint64_t gaps = 0;      ///< Objects of which something had to be asked for.
  std::uint64_t given_up = 0;  ///< Objects that nobody had any more.
};

/// Knows which objects are not whole, and asks for what they lack.
class ObjectReceiver {
 public:
  using Send = std::function<void(const piece_request_t& request)>;

  explicit ObjectReceiver(Send send, const ReceiverLimits& limits = {}) : send_(std::move(send)), limits_(limits) {}

  void add(std::string_view channel, const piece_t& piece, SteadyTime now);
  /// What a sender of a channel that is read here holds.
  void hear(const object_index_t& index, SteadyTime now);
  /// Sends the requests that are due.
  void ask(SteadyTime now);

  bool up_to_date() const { return wanted_.empty(); }  ///< Nothing that was heard of is missing.
  std::size_t wanted() const { return wanted_.size(); }
  std::set<std::string, std::less<>> lacking() const;  ///< The channels of what is wanted.
  const ReceiverCounters& counters() const { return counters_; }
  AssemblerCounters pieces() const;  ///< Of all channels.

 private:
  using Name = std::pair<std::string, std::string>;  // Channel and key.
  struct Wanted {
    std::int64_t version = 0;
    std::int64_t digest = 0;
    std::int32_t npieces = 0;
    SteadyTime heard = 0;
    SteadyTime due = 0;
    SteadyTime interval = 0;
    bool asked = false;
  };

  std::vector<std::map<Name, Wanted>::iterator> in_order();
  Wanted* want(const Name& name, std::int64_t version, std::int64_t digest, std::int32_t npieces, SteadyTime now);
  void request(const Name& name, Wanted& wanted, const IncompleteObject* known, SteadyTime now);

  Send send_;
  ReceiverLimits limits_;
  ReceiverCounters counters_;
  std::map<std::string, ObjectAssembler, std::less<>> assemblers_;  // By channel.
  std::map<Name, Wanted> wanted_;
};

}  // namespace scanway
