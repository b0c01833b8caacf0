#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "common/bus/bus.h"
#include "common/clock/steady_time.h"
#include "common/messages/layout.h"
#include "common/messages/object_assembler.h"
#include "modules/tools/spy/arrivals.h"
#include "modules/tools/spy/gap_counter.h"
#include "scanway/piece_t.hpp"

namespace scanway::tools {

/// What a message on the bus turned out to be.
struct Sighting {
  enum class Kind : std::uint8_t {
    message,  ///< A good message of a type that is known.
    piece,    ///< Of an object.
    object,   ///< Whole, put together from pieces, and a good message itself.
    foreign,  ///< Of a type that nobody here knows.
    bad,      ///< It, or the object that it completes, cannot be what it says it is.
  };

  Kind kind = Kind::foreign;
  std::string_view channel;
  std::span<const std::uint8_t> bytes = {};
  const Layout* layout = nullptr;  ///< Of messages, pieces and objects.
  const piece_t* piece = nullptr;  ///< Of pieces and objects: the piece that came.
  std::string reason = {};         ///< Of bad ones, in one line.
};

/// What was seen of a channel.
struct ChannelTraffic {
  explicit ChannelTraffic(SteadyTime window) : arrivals(window) {}

  std::string type;  ///< Of the last good message or object; of foreign ones the fingerprint.
  bool cut = false;  ///< Objects travel on it in pieces.
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
  std::uint64_t bad = 0;
  std::uint64_t objects = 0;
  std::string last_fault;
  Arrivals arrivals;
  GapCounter gaps;
  std::optional<ObjectAssembler> assembler;
};

/// Watches all channels of a bus: checks what comes, whatever it is, puts objects together, and keeps count.
class Traffic {
 public:
  using Listener = std::function<void(const Sighting&)>;
  using Channels = std::map<std::string, ChannelTraffic, std::less<>>;

  /// Rates are those of the last `window`. `listener` is told of each message, and of each object after its last piece.
  explicit Traffic(SteadyTime window, Listener listener = {}) : window_(window), listener_(std::move(listener)) {}

  void take(const BusMessage& message, SteadyTime now);

  const Channels& channels() const { return channels_; }
  /// Messages of channels beyond the first kMostChannels, which are not looked at.
  std::uint64_t ignored() const { return ignored_; }
  static constexpr std::size_t kMostChannels = 1000;
  static constexpr std::size_t kMostAssemblers = 32;

 private:
  ChannelTraffic* channel(std::string_view name);
  void take_piece(ChannelTraffic& channel, const BusMessage& message, const Layout& layout);
  void take_object(ChannelTraffic& channel, const Object& object, const Sighting& last_piece);
  void refuse(ChannelTraffic& channel, const BusMessage& message, std::string reason);
  void tell(const Sighting& sighting) const;

  SteadyTime window_;
  Listener listener_;
  Channels channels_;
  std::size_t assemblers_ = 0;
  std::uint64_t ignored_ = 0;
};

}  // namespace scanway::tools
