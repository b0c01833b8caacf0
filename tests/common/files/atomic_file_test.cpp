#include "common/files/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>

#include "common/files/input_error.h"
#include "common/files/product_folder.h"
#include "common/files/read_file.h"
#include "tests/support/command.h"

namespace scanway {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const test::ScratchFolder& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Files of this process cannot grow past `bytes` while this lives: a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(AtomicFile, AppearsWholeOrNotAtAll) {
  const test::ScratchFolder folder;
  const std::string path = folder / "a";
  {
    AtomicFile file(path);
    file.write("new");
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_EQ(files_in(folder), 0u);
  AtomicFile file(path);
  file.write("new");
  file.write("er");
  file.commit();
  EXPECT_EQ(test::read_text(path), "newer");
  EXPECT_EQ(files_in(folder), 1u);
}

TEST(AtomicFile, KeepsTheOldStateUntilThen) {
  const test::ScratchFolder folder;
  const std::string path = folder / "a";
  write_file(path, "old");
  {
    AtomicFile file(path);
    file.write("new");
    EXPECT_EQ(test::read_text(path), "old");
  }
  EXPECT_EQ(test::read_text(path), "old");
  write_file(path, "");
  EXPECT_EQ(test::read_text(path), "");
}

TEST(AtomicFile, LeavesNothingWhenTheDiskIsFull) {
  const test::ScratchFolder folder;
  const std::string path = folder / "a";
  write_file(path, "old");
  std::string error;
  {
    const FullDisk disk(1000);
    error = error_of([&] { write_file(path, std::string(5000, 'x')); });
  }
  EXPECT_NE(error.find(path + ": cannot be written: File too large"), std::string::npos) << error;
  EXPECT_EQ(test::read_text(path), "old");
  EXPECT_EQ(files_in(folder), 1u);
}

TEST(AtomicFile, SaysWhyItCannotBeMade) {
  const test::ScratchFolder folder;
  write_file(folder / "file", "");
  const auto error = [](const std::string& path) { return error_of([&] { AtomicFile file(path); }); };
  EXPECT_NE(error(folder / "no/a").find("No such file or directory; make its folder"), std::string::npos);
  EXPECT_NE(error(folder / "file/a").find("Not a directory"), std::string::npos);
  EXPECT_NE(error(folder.path()).find("is a folder or a device"), std::string::npos);
  EXPECT_NE(error("/dev/full").find("is a folder or a device"), std::string::npos);
  EXPECT_NE(error(folder / "no\x1B[2J/a").find("no\\x1B[2J/a"), std::string::npos);
  EXPECT_NE(error(""), "");
  EXPECT_EQ(files_in(folder), 1u);
}

TEST(AtomicFile, KeepsALinkAndTheUsualPermissions) {
  const test::ScratchFolder folder;
  write_file(folder / "target", "old");
  fs::create_symlink("target", folder / "link");
  write_file(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(test::read_text(folder / "target"), "new");
  const mode_t mask = ::umask(022);
  write_file(folder / "b", "");
  ::umask(mask);
  struct stat status {};
  ASSERT_EQ(::stat((folder / "b").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0644u);
}

TEST(AtomicFile, LetsTwoWritersFinish) {
  const test::ScratchFolder folder;
  AtomicFile first(folder / "a"), second(folder / "a");
  first.write("first");
  second.write("second");
  second.commit();
  first.commit();
  EXPECT_EQ(test::read_text(folder / "a"), "first");
  EXPECT_EQ(files_in(folder), 1u);
}

TEST(ProductFolder, IsMadeWithThoseAboveIt) {
  const test::ScratchFolder folder;
  const ProductFolder products(folder / "x/y");
  products.write("map.pcd", "points");
  EXPECT_EQ(test::read_text(folder / "x/y/map.pcd"), "points");
  EXPECT_EQ(products.path_of("map.pcd"), folder / "x/y/map.pcd");
  EXPECT_NO_THROW(ProductFolder(folder / "x/y"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "x/y"), fs::directory_iterator()), 1);
}

TEST(ProductFolder, SaysBeforeTheWorkThatItCannotBeWritten) {
  const test::ScratchFolder folder;
  write_file(folder / "file", "");
  EXPECT_NE(error_of([&] { ProductFolder products(folder / "file"); }).find("Not a directory"), std::string::npos);
  EXPECT_NE(error_of([&] { ProductFolder products(folder / "file/x"); }).find("Not a directory"), std::string::npos);
  EXPECT_NE(error_of([&] { ProductFolder products("/proc/x"); }).find("/proc/x"), std::string::npos);
  EXPECT_NE(error_of([&] { ProductFolder products(""); }), "");
}

TEST(ReadFile, SaysWhyItCannotBeRead) {
  const test::ScratchFolder folder;
  write_file(folder / "a", std::string("zero\0byte", 9));
  EXPECT_EQ(read_file(folder / "a"), std::string("zero\0byte", 9));
  const auto error = [](const std::string& path) { return error_of([&] { read_file(path); }); };
  EXPECT_NE(error(folder / "no").find("No such file"), std::string::npos);
  EXPECT_NE(error(folder.path()).find("is a folder"), std::string::npos);
  EXPECT_NE(error("/dev/zero").find("is not a regular file"), std::string::npos);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(error(folder / "pipe").find("is not a regular file"), std::string::npos);
}

}  // namespace
}  // namespace scanway
