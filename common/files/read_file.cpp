#include "common/files/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <span>

#include "common/files/file_descriptor.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {
namespace {

constexpr std::size_t kPart = std::size_t{1} << 20;
constexpr std::size_t kMaxExpansion = 64;
constexpr std::size_t kMaxExpansionBase = std::size_t{1} << 20;

[[noreturn]] void refuse(const std::string& path, const std::string& problem) {
  throw InputError(printable(path) + ": " + problem);
}

/// Opened without waiting, so that a pipe's name cannot hang a program.
FileDescriptor open_to_read(const std::string& path) {
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open()) refuse(path, "cannot be opened: " + reason_of(errno) + "; check the path and its permissions");
  return file;
}

std::size_t size_of_regular(const FileDescriptor& file, const std::string& path) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) refuse(path, "cannot be examined: " + reason_of(errno));
  if (S_ISDIR(status.st_mode)) refuse(path, "is a folder; name a file in it");
  if (!S_ISREG(status.st_mode)) refuse(path, "is not a regular file; copy the data to a file first");
  return static_cast<std::size_t>(status.st_size);
}

bool is_zstd(const std::string& bytes) { return bytes.starts_with("\x28\xB5\x2F\xFD"); }

/// How many bytes the frames say that they hold, at most `most`; that too if one does not say it.
std::size_t promised_size(std::string_view frames, std::size_t most, const std::string& path) {
  std::size_t total = 0;
  while (!frames.empty()) {
    const std::size_t length = ZSTD_findFrameCompressedSize(frames.data(), frames.size());
    if (ZSTD_isError(length)) refuse(path, "its zstd data is cut or damaged; copy the file again");
    const unsigned long long content = ZSTD_getFrameContentSize(frames.data(), length);
    if (content > most - total) return most;  // Larger, unknown, or not readable, which decompressing will say.
    total += content;
    frames.remove_prefix(length);
  }
  return total;
}

std::string decompress(const std::string& bytes, const std::string& path) {
  const std::size_t most = bytes.size() * kMaxExpansion + kMaxExpansionBase;
  std::string out(promised_size(bytes, most, path), '\0');
  const std::size_t size = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_getErrorCode(size) == ZSTD_error_dstSize_tooSmall) {
    refuse(path, "expands to more than 64 times its size; decompress it with `zstd -d` first");
  }
  if (ZSTD_isError(size)) {
    refuse(path, std::string("its zstd data is damaged (") + ZSTD_getErrorName(size) + "); copy the file again");
  }
  out.resize(size);
  out.shrink_to_fit();
  return out;
}

/// Reads until `bytes` are full or the file ends; how many it got.
std::size_t read_into(std::span<char> bytes, const FileDescriptor& file, const std::string& path) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::read(file.get(), bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(path, "cannot be read: " + reason_of(errno) + "; check the disk");
    if (got == 0) break;  // Somebody shortened it meanwhile: what is left is what there is.
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace

std::string read_file(const std::string& path) {
  const FileDescriptor file = open_to_read(path);
  std::string bytes(size_of_regular(file, path), '\0');
  bytes.resize(read_into(bytes, file, path));
  return bytes;
}

void read_parts(const std::string& path, const std::function<void(std::string_view)>& take) {
  const FileDescriptor file = open_to_read(path);
  std::string part(std::min(size_of_regular(file, path), kPart), '\0');
  while (const std::size_t size = read_into(part, file, path)) take(std::string_view(part).substr(0, size));
}

std::string read_file_decompressed(const std::string& path) {
  std::string bytes = read_file(path);
  return is_zstd(bytes) ? decompress(bytes, path) : bytes;
}

}  // namespace scanway
