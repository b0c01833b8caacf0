#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/files/file_descriptor.h"

namespace scanway::simulator {

/// The device's end of a serial line: a pseudo-terminal, and a link that names the host's end.
class TerminalEnd {
 public:
  /// `link`: where the host finds its end; a link that was left behind is replaced. Throws InputError when a file of
  /// another kind is there.
  explicit TerminalEnd(std::string link);
  ~TerminalEnd();
  TerminalEnd(const TerminalEnd&) = delete;
  TerminalEnd& operator=(const TerminalEnd&) = delete;

  const std::string& link() const { return link_; }
  /// What came; does not wait.
  std::vector<std::uint8_t> hear();
  /// False: nobody fetches what is sent, and the bytes are dropped.
  bool say(std::span<const std::uint8_t> bytes);
  /// The rate that the host has set.
  int baud() const;

 private:
  std::string link_;
  FileDescriptor device_, host_;
};

}  // namespace scanway::simulator
