#pragma once

#include <ostream>

#include <nlohmann/json.hpp>

namespace scanway::tools {

/// One JSON document on a line of its own. Bytes that are no UTF-8 are shown as U+FFFD.
inline void write_line(std::ostream& out, const nlohmann::ordered_json& line) {
  out << line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

}  // namespace scanway::tools
