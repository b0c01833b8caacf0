#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "common/time/utime.h"
#include "scanway/input_span_t.hpp"

namespace scanway {

/// The messages of one channel, each once, by their own times; those of the same time by their bytes. So what it holds
/// does not depend on the order in which they came.
class RawChannel {
 public:
  using Message = std::pair<Utime, std::vector<std::uint8_t>>;
  using Messages = std::vector<const Message*>;

  /// When it holds more than `most_bytes`, the oldest go.
  explicit RawChannel(std::size_t most_bytes = std::size_t{32} << 20) : most_bytes_(most_bytes) {}

  /// False for one that is there.
  bool add(Utime utime, std::span<const std::uint8_t> bytes);
  void forget_before(Utime utime);

  /// Those of the times from `first` to `last`.
  Messages from_to(Utime first, Utime last) const;
  /// The same, and of the messages beside them the last one before and the first one after.
  Messages around(Utime first, Utime last) const;
  std::optional<Utime> newest() const;

 private:
  struct Earlier {
    using is_transparent = void;
    bool operator()(const Message& a, const Message& b) const {
      return a.first != b.first ? a.first < b.first : text_of(a) < text_of(b);
    }
    bool operator()(const Message& a, Utime b) const { return a.first < b; }
    bool operator()(Utime a, const Message& b) const { return a < b.first; }
    static std::string_view text_of(const Message& message) {
      return {reinterpret_cast<const char*>(message.second.data()), message.second.size()};
    }
  };

  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::set<Message, Earlier> messages_;
};

/// What SWEEP_INPUTS says of the messages that were used.
input_span_t span_of(std::string_view channel, const RawChannel::Messages& used, std::int64_t late);

}  // namespace scanway
