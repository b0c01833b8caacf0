#include "modules/mapper/node/sweeps_on_disk.h"

#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "common/messages/codec.h"
#include "common/messages/sweep_message.h"

namespace scanway {
namespace {

FileDescriptor nameless_file() {
  std::error_code none;
  std::string name = (std::filesystem::temp_directory_path(none) / "scanway-sweeps-XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file >= 0) unlink(name.c_str());
  return FileDescriptor(file);
}

bool write_all(int file, std::span<const std::uint8_t> bytes, std::int64_t offset) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file, bytes.data(), bytes.size(), offset);
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += written;
  }
  return true;
}

bool read_all(int file, std::span<std::uint8_t> bytes, std::int64_t offset) {
  while (!bytes.empty()) {
    const ssize_t got = pread(file, bytes.data(), bytes.size(), offset);
    if (got <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += got;
  }
  return true;
}

}  // namespace

SweepsOnDisk::SweepsOnDisk() : file_(nameless_file()) {}

void SweepsOnDisk::keep(const Sweep& sweep) {
  std::vector<std::uint8_t> bytes = encode(sweep);
  Kept kept{end_, bytes.size(), {}, sweep.R_world_sweep};
  if (file_.is_open() && write_all(file_.get(), bytes, end_)) {
    end_ += static_cast<std::int64_t>(bytes.size());
  } else {
    kept.bytes = std::move(bytes);
  }
  sweeps_.push_back(std::move(kept));
}

Sweep SweepsOnDisk::fetch(std::size_t number) const {
  const Kept& kept = sweeps_.at(number);
  std::vector<std::uint8_t> bytes = kept.bytes;
  if (bytes.empty()) {
    bytes.resize(kept.size);
    if (!read_all(file_.get(), bytes, kept.offset))
      throw std::runtime_error("a sweep cannot be read back from the disk");
  }
  Sweep sweep = decode<Sweep>(bytes);
  sweep.R_world_sweep = kept.R_world_sweep;
  return sweep;
}

}  // namespace scanway
