#pragma once

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <string>

#include "common/files/file_descriptor.h"
#include "tests/modules/xsens_bridge/emulated_tracker.h"

namespace scanway::test {

/// A tracker at the other end of a pseudo-terminal, in this process.
class TerminalTracker {
 public:
  explicit TerminalTracker(bool legacy) : tracker_(legacy), master_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
    if (grantpt(master_.get()) != 0 || unlockpt(master_.get()) != 0) ADD_FAILURE() << "no pseudo-terminal";
    // Held open, so that the tracker's end outlives the bridge's openings.
    held_ = FileDescriptor(open(path().c_str(), O_RDWR | O_NOCTTY));
    termios raw{};
    tcgetattr(held_.get(), &raw);
    cfmakeraw(&raw);  // A new terminal echoes; a serial line does not.
    tcsetattr(held_.get(), TCSANOW, &raw);
  }

  std::string path() const { return ptsname(master_.get()); }

  void run() {
    std::uint8_t bytes[1024];
    const ssize_t count = read(master_.get(), bytes, sizeof bytes);
    if (count > 0) put(tracker_.answer(std::span(bytes).first(static_cast<std::size_t>(count))));
    if (!quiet) put(tracker_.measure());
  }

  void put(const Bytes& bytes) {
    if (!bytes.empty() && write(master_.get(), bytes.data(), bytes.size()) < 0) ++lost;
  }

  EmulatedTracker& tracker() { return tracker_; }
  bool quiet = false;  ///< It answers, and measures nothing of its own.
  int lost = 0;        ///< Writes that the line did not take.

 private:
  EmulatedTracker tracker_;
  FileDescriptor master_, held_;
};

}  // namespace scanway::test
