#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "common/cloud/read_cloud.h"
#include "common/files/input_error.h"
#include "tests/support/command.h"

namespace scanway {

/// Writes a file into `folder` and says where.
inline std::string write_file_in(const test::ScratchFolder& folder, const std::string& name, const std::string& bytes) {
  test::write_text(folder / name, bytes);
  return folder / name;
}

/// The cloud of a file with these bytes.
inline PointCloud read_bytes(const std::string& name, const std::string& bytes, CloudNotes* notes = nullptr) {
  const test::ScratchFolder folder;
  return read_cloud(write_file_in(folder, name, bytes), notes);
}

/// What read_cloud() says of a file with these bytes; empty when it reads them.
inline std::string error_of(const std::string& name, const std::string& bytes) {
  try {
    read_bytes(name, bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The bytes of `value`, least significant first.
template <class T>
std::string little(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

/// The bytes of `value`, most significant first.
template <class T>
std::string big(T value) {
  const std::string bytes = little(value);
  return {bytes.rbegin(), bytes.rend()};
}

}  // namespace scanway
