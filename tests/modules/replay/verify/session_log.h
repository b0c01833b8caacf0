#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/time/utime.h"
#include "tests/support/command.h"

namespace scanway::test {

/// An event of a log that is being written anew.
struct EditedEvent {
  std::string channel;
  Utime utime = 0;
  std::vector<std::uint8_t> bytes;
};

/// A log of two scans of a small room, an orientation each and a goal, with all that is derived from them; made once.
class SessionLog {
 public:
  static const SessionLog& get();

  const std::string& path() const { return path_; }
  const std::string& inputs_path() const { return inputs_path_; }
  /// The log with its events as `edit` leaves them; it may add and remove. Returns the new log's path.
  std::string edited(const std::string& name, const std::function<void(std::vector<EditedEvent>&)>& edit) const;

 private:
  SessionLog();

  ScratchFolder folder_;
  std::string path_;
  std::string inputs_path_;
};

constexpr Utime kFirstSweep = 1'700'000'000 * kMicrosecondsPerSecond;
constexpr Utime kSecondSweep = kFirstSweep + 20 * kMicrosecondsPerSecond;
constexpr Utime kImuBefore = 10'000;

/// All events of a channel, to change them.
std::vector<EditedEvent*> events_of(std::vector<EditedEvent>& events, std::string_view channel);

}  // namespace scanway::test
