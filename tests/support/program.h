#pragma once

#include <sys/types.h>

#include <csignal>
#include <string>
#include <vector>

namespace scanway::test {

/// A program that runs beside the test, with what it says on stdout and stderr in files.
class Program {
 public:
  Program(const std::vector<std::string>& words, const std::string& out, const std::string& err = "/dev/null");
  /// Kills it, if it still runs.
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  bool runs();
  /// Sends it the signal and waits for its end. Returns its status, 128 + N if signal N ended it.
  int end(int signal = SIGTERM);

 private:
  pid_t child_;
  int status_ = -1;  // Once it has ended.
};

}  // namespace scanway::test
