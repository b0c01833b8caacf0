#include "common/files/file_digest.h"

#include <xxhash.h>

#include <memory>

#include "common/files/read_file.h"

namespace scanway {

std::uint64_t file_digest(const std::string& path) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), &XXH3_freeState);
  XXH3_64bits_reset(state.get());
  read_parts(path, [&](std::string_view part) { XXH3_64bits_update(state.get(), part.data(), part.size()); });
  return XXH3_64bits_digest(state.get());
}

}  // namespace scanway
