#pragma once

#include <string>
#include <string_view>

namespace scanway {

/// The folder that a command's products go to.
class ProductFolder {
 public:
  /// Makes the folder, and those above it, where they are missing, and tries that files can be written there: before
  /// the long work, not after it. Throws InputError.
  explicit ProductFolder(std::string path);

  const std::string& path() const { return path_; }
  /// The path of the product `name`.
  std::string path_of(std::string_view name) const;
  /// Writes the product `name` (atomic_file.h).
  void write(std::string_view name, std::string_view bytes) const;

 private:
  std::string path_;
};

}  // namespace scanway
