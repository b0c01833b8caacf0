#pragma once

#include <string>
#include <string_view>

#include "common/files/file_descriptor.h"

namespace scanway {

/// A file that appears whole or not at all. What is written goes to a file beside it; commit() brings that to the disk
/// and puts it in the old one's place. Without commit() the old state stays. Every failure throws InputError that names
/// the path, the system's reason and what to do.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  void commit();

  const std::string& path() const { return path_; }
  /// Where the bytes are until commit(): for libraries that write to a path themselves.
  const std::string& path_until_commit() const { return temporary_; }

 private:
  [[noreturn]] void fail(const std::string& what, int error) const;

  std::string path_;
  std::string temporary_;
  FileDescriptor file_;
};

/// The whole file at once.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace scanway
