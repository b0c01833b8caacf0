#include "common/bus/mapped_file.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include "common/files/file_descriptor.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {

MappedFile::MappedFile(const std::string& path) {
  const auto fail = [&](const std::string& why) { throw InputError(printable(path) + ": cannot be read: " + why); };
  // Without waiting for whoever might write to a FIFO of that name.
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open()) fail(reason_of(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) fail(reason_of(errno));
  if (!S_ISREG(status.st_mode)) fail("not a regular file");
  if (status.st_size == 0) return;
  const auto size = static_cast<std::size_t>(status.st_size);
  void* const address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.get(), 0);
  if (address == MAP_FAILED) fail(reason_of(errno));
  bytes_ = {static_cast<const std::uint8_t*>(address), size};
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<std::uint8_t*>(bytes_.data()), bytes_.size());
}

}  // namespace scanway
