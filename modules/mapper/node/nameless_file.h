#pragma once

#include <cstdint>
#include <span>

#include "common/files/file_descriptor.h"

namespace scanway {

/// A file among the machine's temporary ones without a name, which goes when the process does.
class NamelessFile {
 public:
  NamelessFile();

  /// False where the disk takes no more; what was there is then lost.
  bool write(std::span<const std::uint8_t> bytes, std::int64_t offset);
  /// Throws std::runtime_error.
  void read(std::span<std::uint8_t> bytes, std::int64_t offset) const;

 private:
  FileDescriptor file_;
};

}  // namespace scanway
