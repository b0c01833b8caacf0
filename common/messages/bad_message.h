#pragma once

#include <stdexcept>

namespace scanway {

/// A message or a piece that cannot be what it says it is. what() says why, in one line.
class BadMessage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace scanway
