#include "common/files/product_folder.h"

#include <filesystem>
#include <utility>

#include "common/files/atomic_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {

ProductFolder::ProductFolder(std::string path) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (!error && !std::filesystem::is_directory(path_, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) {
    throw InputError(printable(path_) + ": cannot be made as a folder for the output: " + error.message() +
                     "; choose another with -o");
  }
  const AtomicFile trial(path_of(".scanway-trial"));  // Gone at once: it is never committed.
}

std::string ProductFolder::path_of(std::string_view name) const {
  return (std::filesystem::path(path_) / name).string();
}

void ProductFolder::write(std::string_view name, std::string_view bytes) const { write_file(path_of(name), bytes); }

}  // namespace scanway
