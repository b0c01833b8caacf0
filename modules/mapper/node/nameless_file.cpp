#include "modules/mapper/node/nameless_file.h"

#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace scanway {
namespace {

FileDescriptor nameless_file() {
  std::error_code none;
  std::string name = (std::filesystem::temp_directory_path(none) / "scanway-map-XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file >= 0) unlink(name.c_str());
  return FileDescriptor(file);
}

}  // namespace

NamelessFile::NamelessFile() : file_(nameless_file()) {}

bool NamelessFile::write(std::span<const std::uint8_t> bytes, std::int64_t offset) {
  if (!file_.is_open()) return false;
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file_.get(), bytes.data(), bytes.size(), offset);
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += written;
  }
  return true;
}

void NamelessFile::read(std::span<std::uint8_t> bytes, std::int64_t offset) const {
  while (!bytes.empty()) {
    const ssize_t got = pread(file_.get(), bytes.data(), bytes.size(), offset);
    if (got <= 0) throw std::runtime_error("what the map keeps of its sweeps cannot be read back from the disk");
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += got;
  }
}

}  // namespace scanway
