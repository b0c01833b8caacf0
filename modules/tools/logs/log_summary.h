#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "common/bus/log_reader.h"
#include "common/messages/object_assembler.h"
#include "common/time/utime.h"

namespace scanway::tools {

/// What a log holds of a channel.
struct ChannelSummary {
  std::uint64_t count = 0;  ///< Messages; pieces, of what is cut.
  std::uint64_t bytes = 0;
  Utime first_utime = 0;  ///< By the log's own times.
  Utime last_utime = 0;
  std::map<std::int64_t, std::uint64_t> fingerprints;  ///< Messages by type.
  std::uint64_t bad_messages = 0;                      ///< Of a known type, but not one of its messages.
  std::uint64_t unexpected = 0;                        ///< Of another type than the channel's in lcmtypes/README.md.
  std::string first_fault;                             ///< Why the first bad message or object is bad.

  /// Of channels with numbered pieces.
  std::optional<ObjectAssembler> assembler;
  std::map<std::int64_t, std::uint64_t> object_fingerprints;
  std::uint64_t bad_objects = 0;  ///< Whole, but not what they say.
  std::uint64_t missing_pieces() const;

  /// Messages a second, between the first and the last; 0 if that is no time.
  double rate_hz() const;
  bool damaged() const { return bad_messages > 0 || bad_objects > 0; }
};

/// What a log holds.
struct LogSummary {
  std::uint64_t file_bytes = 0;
  std::uint64_t events = 0;
  Utime first_utime = 0;
  Utime last_utime = 0;
  std::optional<std::int32_t> schema;  ///< Of the last configuration in it.
  std::map<std::string, ChannelSummary> channels;
  std::string trouble;  ///< Of the file, in one line; empty if there is none.
  bool cut = false;
  std::uint64_t damaged_stretches = 0;
  std::uint64_t skipped_bytes = 0;

  bool damaged() const;
};

/// Reads the rest of `log`.
LogSummary summarize(LogReader& log);

/// The name of the type with that fingerprint, or the fingerprint in hexadecimal digits.
std::string type_name(std::int64_t fingerprint);

}  // namespace scanway::tools
