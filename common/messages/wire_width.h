#pragma once

#include <cstddef>

#include "common/messages/layout.h"

namespace scanway {

/// Bytes of one number of that kind on the wire; 0 for what has no fixed width.
constexpr std::size_t wire_width(Layout::Kind kind) {
  switch (kind) {
    case Layout::Kind::int8:
      return 1;
    case Layout::Kind::int16:
      return 2;
    case Layout::Kind::int32:
    case Layout::Kind::float32:
      return 4;
    case Layout::Kind::int64:
    case Layout::Kind::float64:
      return 8;
    case Layout::Kind::string:
    case Layout::Kind::nested:
      break;
  }
  return 0;
}

}  // namespace scanway
