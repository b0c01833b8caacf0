#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/support/command.h"

namespace scanway::test {

/// Whether this machine lets us make network namespaces, in which the live tests keep their packets.
bool namespaces_permitted();

/// Two scans of the hall with a quarter of their points as a log, and what one process makes of it.
struct ShortLog {
  static const ShortLog& get();  ///< Made once a test program.

  ScratchFolder folder;
  std::string log;
  std::string products;  ///< As scanway-live-tool prints them.

 private:
  ShortLog();
};

/// The processes on a bus of their own.
class Session {
 public:
  /// A shell script on one pretend machine; session.sh is sourced, and the loopback interface is up.
  CommandResult run(const std::string& script) const;
  /// One script a pretend machine of a pretend LAN; the last one is the test. `options`: of netns-lan.
  CommandResult run_on_lan(const std::vector<std::string>& options, const std::vector<std::string>& scripts) const;

  std::string operator/(const std::string& file) const { return folder_ / file; }
  std::string text(const std::string& file) const { return read_text(folder_ / file); }
  /// What was observed of that channel (all that replay compares: empty), a line an object.
  std::string observed(const std::string& channel = {}) const;
  /// A process's last counters on HEALTH.
  std::map<std::string, long> counters(const std::string& process) const;
  /// Everything that helps to see what went wrong.
  std::string told() const;

 private:
  std::string head() const;

  ScratchFolder folder_;
};

/// The lines of `products` that begin with that channel.
std::string lines_of(const std::string& products, const std::string& channel);

}  // namespace scanway::test
