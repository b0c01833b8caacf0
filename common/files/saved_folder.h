#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "common/files/file_descriptor.h"
#include "common/files/product_folder.h"

namespace scanway {

/// Files in a folder that belong together, replaced all at once. They are listed with their XXH3-64 in
/// `checksums.xxh3`, which `xxhsum -c checksums.xxh3` checks too. Other files of the folder are left alone, but a
/// folder within it that holds listed files holds no others.
///
/// A save writes every file into `.saving/`, beside the old ones, and then moves the new list into its place: with that
/// one step the new files are the ones that count. What follows only moves them to where they belong, and is made up
/// for by the next who opens the folder. So whenever it is interrupted, all of the old or all of the new is there.
class SavedFolder {
 public:
  /// Whether something was ever saved there.
  static bool is_one(const std::string& folder);

  /// Finishes a save that was interrupted after its list was in place, and compares every file with the list. Throws
  /// InputError that names the file which is damaged or missing.
  explicit SavedFolder(std::string folder);

  std::string path_of(const std::string& name) const { return folder_ + "/" + name; }
  bool has(const std::string& name) const { return digests_.contains(name); }
  /// By the file's name, with a / for those in folders below.
  const std::map<std::string, std::uint64_t>& digests() const { return digests_; }

 private:
  std::string folder_;
  std::map<std::string, std::uint64_t> digests_;
};

/// A save under way. Without commit() the old state stays.
class FolderSave {
 public:
  /// Makes the folder where it is missing. Throws InputError, also while another process saves there.
  explicit FolderSave(std::string folder);
  ~FolderSave();
  FolderSave(const FolderSave&) = delete;
  FolderSave& operator=(const FolderSave&) = delete;

  /// Where the new files are to be written, under their names.
  const ProductFolder& files() const { return files_; }
  /// All that was written counts from now on, and nothing that was saved before. Throws InputError.
  void commit();

 private:
  std::string folder_;
  FileDescriptor lock_;
  ProductFolder files_;
};

}  // namespace scanway
