#include "common/files/saved_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "common/files/atomic_file.h"
#include "common/files/file_digest.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/read_file.h"
#include "common/files/text_lines.h"

namespace scanway {
namespace {

namespace fs = std::filesystem;
using Digests = std::map<std::string, std::uint64_t>;

constexpr const char* kList = "checksums.xxh3";
constexpr const char* kStaging = ".saving";
constexpr std::string_view kBegin = "XXH3 (", kBetween = ") = ";

std::string list_of(const std::string& folder) { return folder + "/" + kList; }
std::string staging_of(const std::string& folder) { return folder + "/" + kStaging; }

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw InputError(printable(path) + ": " + what);
}

bool holds(const std::string& path, std::uint64_t digest) {
  return fs::is_regular_file(path) && file_digest(path) == digest;
}

std::string hexadecimal(std::uint64_t digest) {
  std::string digits(16, '0');
  for (std::size_t i = digits.size(); i-- > 0; digest >>= 4) digits[i] = "0123456789abcdef"[digest & 15];
  return digits;
}

std::string text_of(const Digests& digests) {
  std::string text;
  for (const auto& [name, digest] : digests) {
    text += std::string(kBegin) + name + std::string(kBetween) + hexadecimal(digest) + "\n";
  }
  return text;
}

/// A list must not lead out of its folder.
bool is_inside(const fs::path& name) {
  if (name.empty() || !name.is_relative()) return false;
  for (const fs::path& part : name) {
    if (part == ".." || part == "." || part == kStaging || part.empty()) return false;
  }
  return true;
}

std::optional<Digests::value_type> entry_of(std::string_view line) {
  const std::size_t end = line.rfind(kBetween);
  if (!line.starts_with(kBegin) || end == std::string_view::npos) return std::nullopt;
  const std::string_view digits = line.substr(end + kBetween.size());
  std::uint64_t digest = 0;
  const auto [stop, error] = std::from_chars(digits.begin(), digits.end(), digest, 16);
  if (error != std::errc() || stop != digits.end() || digits.size() != 16) return std::nullopt;
  std::string name(line.substr(kBegin.size(), end - kBegin.size()));
  if (!is_inside(name)) return std::nullopt;
  return Digests::value_type(std::move(name), digest);
}

Digests read_list(const std::string& folder) {
  const std::string path = list_of(folder), text = read_file(path);
  Digests digests;
  TextLines lines(text);
  while (const auto line = lines.next()) {
    auto entry = entry_of(*line);
    if (!entry)
      fail(path + ":" + std::to_string(lines.number()), "is no line XXH3 (FILE) = DIGEST; save the map again");
    digests.insert(std::move(*entry));
  }
  if (digests.empty()) fail(path, "lists no file; save the map again");
  return digests;
}

/// All files below the folder, by their names there.
std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(folder).string());
  }
  return names;
}

void sync_folder(const fs::path& folder) {
  const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.is_open()) ::fsync(opened.get());
}

/// Makes of every file that the list names the file that it names; the staged ones that others need are gone then.
void move_into_place(const std::string& folder, const Digests& digests) {
  std::set<fs::path> touched = {folder};
  for (const auto& [name, digest] : digests) {
    const fs::path staged = fs::path(staging_of(folder)) / name, place = fs::path(folder) / name;
    if (!holds(staged, digest)) continue;
    fs::create_directories(place.parent_path());
    fs::rename(staged, place);
    touched.insert(place.parent_path());
  }
  for (const fs::path& one : touched) sync_folder(one);
}

/// In the folders within the folder, what the list does not name is of an older save.
void remove_unlisted(const std::string& folder, const Digests& digests) {
  std::set<std::string> owned;
  for (const auto& [name, digest] : digests) {
    if (name.find('/') != std::string::npos) owned.insert(name.substr(0, name.find('/')));
  }
  for (const std::string& below : owned) {
    for (const std::string& file : files_below(folder + "/" + below)) {
      if (!digests.contains(below + "/" + file)) fs::remove(fs::path(folder) / below / file);
    }
  }
}

void finish_save(const std::string& folder, const Digests& digests) {
  try {
    if (!fs::exists(staging_of(folder))) return;
    move_into_place(folder, digests);
    remove_unlisted(folder, digests);
    fs::remove_all(staging_of(folder));
  } catch (const fs::filesystem_error& error) {
    fail(folder, "a save that was interrupted cannot be finished: " + error.code().message());
  }
}

/// Not open while another process saves there.
FileDescriptor locked(const std::string& folder) {
  FileDescriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const bool is_mine = file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0;
  return is_mine ? std::move(file) : FileDescriptor();
}

/// The staging folder, empty.
std::string begin_save(const std::string& folder, const FileDescriptor& lock) {
  if (!lock.is_open()) fail(folder, "another process saves there; wait for its end, or choose another folder");
  if (SavedFolder::is_one(folder)) finish_save(folder, read_list(folder));
  std::error_code error;
  fs::remove_all(staging_of(folder), error);
  return staging_of(folder);
}

}  // namespace

bool SavedFolder::is_one(const std::string& folder) { return fs::is_regular_file(list_of(folder)); }

SavedFolder::SavedFolder(std::string folder) : folder_(std::move(folder)) {
  if (!is_one(folder_)) fail(folder_, std::string("is no saved map: it has no ") + kList);
  const FileDescriptor lock = locked(folder_);
  digests_ = read_list(folder_);
  if (lock.is_open()) finish_save(folder_, digests_);  // Else somebody is at work on a new save.
  for (const auto& [name, digest] : digests_) {
    if (!fs::is_regular_file(path_of(name))) fail(path_of(name), "is missing from the saved map; save the map again");
    if (file_digest(path_of(name)) != digest) {
      fail(path_of(name), std::string("is damaged: it is not what ") + kList + " says; save the map again");
    }
  }
}

FolderSave::FolderSave(std::string folder)
    : folder_(ProductFolder(std::move(folder)).path()), lock_(locked(folder_)), files_(begin_save(folder_, lock_)) {}

FolderSave::~FolderSave() {
  std::error_code none;
  fs::remove_all(staging_of(folder_), none);
}

void FolderSave::commit() {
  Digests digests;
  for (const std::string& name : files_below(staging_of(folder_))) {
    digests[name] = file_digest(files_.path_of(name));
    sync_folder(fs::path(files_.path_of(name)).parent_path());
  }
  const std::string list = files_.path_of(kList);
  write_file(list, text_of(digests));
  std::error_code error;
  fs::rename(list, list_of(folder_), error);
  if (error) fail(list_of(folder_), "cannot be put in its place: " + error.message());
  sync_folder(folder_);
  finish_save(folder_, digests);
}

}  // namespace scanway
