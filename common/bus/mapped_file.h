#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace scanway {

/// A file's bytes, as they are when it is opened, in the address space: any part of a large file without a copy.
class MappedFile {
 public:
  /// Throws InputError when it is no regular file or cannot be read.
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const std::uint8_t> bytes() const { return bytes_; }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace scanway
