#pragma once

#include <string>
#include <utility>

namespace scanway {

/// An open file that is closed when its owner goes.
class FileDescriptor {
 public:
  explicit FileDescriptor(int fd = -1) : fd_(fd) {}
  ~FileDescriptor() { close(); }
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }

  bool is_open() const { return fd_ >= 0; }
  int get() const { return fd_; }
  /// False when closing reports that earlier writes were lost.
  bool close();

 private:
  int fd_;
};

/// The system's reason for `error` (an errno) in words: "Permission denied".
std::string reason_of(int error);

}  // namespace scanway
