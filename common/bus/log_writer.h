#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "common/files/atomic_file.h"
#include "common/time/utime.h"

namespace scanway {

/// Writes a log in LCM's event log format. The file appears under its name when close() returns, whole and on the
/// disk, or not at all: until then it is a temporary file beside it, which goes when the writer does.
class LogWriter {
 public:
  /// Throws InputError when the folder cannot be written.
  explicit LogWriter(std::string path);

  /// Appends an event; events are numbered from 0. Throws InputError when the disk is full or the like, and
  /// std::invalid_argument for a channel name that is empty or longer than LCM's 63 bytes.
  void write(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime);
  /// Puts the log in its place. Throws InputError.
  void close();
  std::int64_t events() const { return events_; }

 private:
  void flush();

  AtomicFile file_;
  std::string waiting_;  // Events that were not handed to the file yet.
  std::int64_t events_ = 0;
};

}  // namespace scanway
