#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/bus/mapped_file.h"
#include "common/time/utime.h"

namespace scanway {

/// An event of a log. It is borrowed from the reader, and lives as long as that does.
struct LogEvent {
  std::int64_t number = 0;  ///< As the log counts.
  Utime utime = 0;          ///< When the logger got it.
  std::string_view channel;
  std::span<const std::uint8_t> bytes;
  std::uint64_t offset = 0;  ///< Of its first byte in the file.
};

/// A stretch of a log that holds no event that can be trusted.
struct LogDamage {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::int64_t after_event = -1;  ///< Number of the last good event before it; -1: none.
  bool cut = false;               ///< It is an event that the end of the file cuts off.
  std::string reason;
};

/// Reads a log in LCM's event log format: its good events one after the other, whatever bytes the file holds. It reads
/// from a memory map and allocates nothing by what the file says.
class LogReader {
 public:
  /// Throws InputError when the file cannot be read or holds no event and no beginning of one.
  explicit LogReader(const std::string& path);

  /// The next good event, or nothing at the end. Damaged stretches are passed over and noted.
  std::optional<LogEvent> next();

  /// The damage passed so far: the first kDamagesKept stretches.
  const std::vector<LogDamage>& damages() const { return damages_; }
  static constexpr std::size_t kDamagesKept = 100;
  std::uint64_t damage_count() const { return damage_count_; }    ///< All stretches, kept or not.
  std::uint64_t skipped_bytes() const { return skipped_bytes_; }  ///< Of all stretches.
  bool cut() const { return cut_; }                               ///< The file's end cuts an event off.
  std::uint64_t file_bytes() const { return file_.bytes().size(); }
  /// One line for people on what is wrong with the part that was read; empty if nothing is.
  std::string trouble() const;

 private:
  LogEvent event_at(std::uint64_t begin, std::uint64_t end) const;
  void note_damage(std::uint64_t begin, std::uint64_t end);

  MappedFile file_;
  std::uint64_t offset_ = 0;
  std::int64_t last_good_ = -1;
  std::vector<LogDamage> damages_;
  std::uint64_t damage_count_ = 0;
  std::uint64_t skipped_bytes_ = 0;
  bool cut_ = false;
};

}  // namespace scanway
