#include "common/files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {
namespace {

std::string advice_for(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "; make room on the disk or choose another place";
    case ENOENT:
    case ENOTDIR:
      return "; make its folder first or choose another place";
    case EACCES:
    case EPERM:
    case EROFS:
      return "; choose a place that you may write to";
    default:
      return "; choose another place";
  }
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// The file that a link leads to, so that replacing it keeps the link.
std::string without_links(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target.string();
}

/// A new file beside `path`, with a name of this process's own.
FileDescriptor create_beside(const std::string& path, std::string& name) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    name = path + ".part-" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
    FileDescriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.is_open() || errno != EEXIST) return file;
  }
  return FileDescriptor();
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(without_links(path)) {
  if (path_.empty()) throw InputError("the name of a file to write is empty; give one");
  struct stat status {};
  if (::stat(path_.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    throw InputError(printable(path_) + ": is a folder or a device; choose the name of a file to write");
  }
  file_ = create_beside(path_, temporary_);
  if (!file_.is_open()) fail("cannot be written", errno);
}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(file_.get(), bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail("cannot be written", errno);
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

void AtomicFile::commit() {
  if (::fsync(file_.get()) != 0) fail("cannot be brought to the disk", errno);
  if (!file_.close()) fail("cannot be brought to the disk", errno);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot be put in its place", errno);
  temporary_.clear();
  // The new name itself is safe only when the folder is. Some file systems cannot do this: then nothing is to be done.
  const FileDescriptor folder(::open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) ::fsync(folder.get());
}

void AtomicFile::fail(const std::string& what, int error) const {
  throw InputError(printable(path_) + ": " + what + ": " + reason_of(error) + advice_for(error));
}

void write_file(const std::string& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace scanway
