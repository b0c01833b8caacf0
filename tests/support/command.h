#pragma once

#include <string>
#include <vector>

namespace scanway::test {

/// What a program did.
struct CommandResult {
  int status = -1;  ///< Exit status; 128 + N when signal N ended it.
  std::string out;
  std::string err;
};

/// Runs a program to its end, without a shell and without standard input. `environment`: NAME=VALUE on top of ours.
CommandResult run_command(const std::vector<std::string>& words, const std::vector<std::string>& environment = {});

/// A new empty folder that is removed with everything in it when the object goes.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string read_text(const std::string& path);
void write_text(const std::string& path, const std::string& text);

}  // namespace scanway::test
