#pragma once

#include <stdexcept>

namespace scanway {

/// Input that cannot be used. what() is one line for the user: it names the file, device, field or key, what was wrong
/// and what to do. Programs print it and exit with 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace scanway
