#include "common/files/file_descriptor.h"

#include <unistd.h>

#include <system_error>

namespace scanway {

bool FileDescriptor::close() {
  if (!is_open()) return true;
  return ::close(std::exchange(fd_, -1)) == 0;
}

std::string reason_of(int error) { return std::generic_category().message(error); }

}  // namespace scanway
