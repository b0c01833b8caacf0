#pragma once

#include <cstdint>
#include <map>
#include <ranges>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/channels.h"
#include "common/bus/log_reader.h"
#include "modules/replay/verify/recorded_object.h"
#include "scanway/path_t.hpp"
#include "scanway/sweep_inputs_t.hpp"

namespace scanway {

/// What the mapper derives, in the order in which it publishes it. All of it carries the time of the sweep.
inline constexpr const Channel* kMapperProducts[] = {
    &channel::kSweepInputs,  &channel::kRegistration, &channel::kPose,   &channel::kCostMapTile,
    &channel::kCostMapIndex, &channel::kCloudTile,    &channel::kOctomap};

/// What a message that is not cut in pieces is compared by. What a sweep came too late for is not known to who replays
/// it: SWEEP_INPUTS is compared without.
RecordedName name_of(std::string_view channel, std::span<const std::uint8_t> message);

/// What a log holds, each thing once, however often it was sent.
class RecordedLog {
 public:
  using Bytes = std::span<const std::uint8_t>;
  using Objects = std::map<RecordedName, RecordedObject>;

  /// Throws InputError when the file cannot be read.
  explicit RecordedLog(const std::string& path);

  /// By channel, key, version and digest.
  const Objects& objects() const { return objects_; }
  std::ranges::subrange<Objects::const_iterator> objects_of(const Channel& channel) const;
  /// The good messages of a channel that is not cut, by the time that they say.
  const std::multimap<Utime, Bytes>& messages(std::string_view channel) const;
  /// SWEEP_INPUTS, in the order in which they were said first.
  const std::vector<sweep_inputs_t>& sweep_inputs() const { return sweep_inputs_; }

  /// What the mapper derived of the sweep of that time.
  std::vector<RecordedName> products_at(Utime sweep) const;
  /// The times of all sweeps that the mapper derived something of, as what is not altered says.
  std::set<Utime> sweeps() const;
  /// The first product of the mapper that is not what was sent, and why; empty: there is none.
  std::string first_fault() const;
  /// Whether mapper or planner derived anything that is compared.
  bool holds_derived() const;

  /// Messages of derived channels that are none.
  const std::vector<std::string>& bad_messages() const { return bad_messages_; }
  std::string trouble() const { return log_.trouble(); }

 private:
  void take(const LogEvent& event);
  void take_piece(const LogEvent& event);
  void take_message(const Channel& channel, const LogEvent& event);

  LogReader log_;
  Objects objects_;
  std::map<std::string, std::multimap<Utime, Bytes>, std::less<>> messages_;
  std::vector<sweep_inputs_t> sweep_inputs_;
  std::map<Utime, std::set<RecordedName>> products_;  // Of the mapper, by the time of the sweep.
  std::vector<std::string> bad_messages_;
};

}  // namespace scanway
