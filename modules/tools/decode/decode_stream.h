#pragma once

#include <cstdint>
#include <exception>
#include <ostream>
#include <span>

#include <nlohmann/json.hpp>

#include "common/bytes/frame_finder.h"
#include "modules/tools/output/json_line.h"

namespace scanway::tools {

inline nlohmann::ordered_json bad_line(const Stretch& stretch, const std::string& reason) {
  return {{"type", "bad"}, {"offset", stretch.offset}, {"length", stretch.length}, {"reason", reason}};
}

/// Writes a line for each stretch of `bytes`: what `line_of_frame` makes of a whole frame, or of type `bad` where there
/// is none, or where that throws.
template <class LineOfFrame>
void decode_stream(FrameFinder& finder, std::span<const std::uint8_t> bytes, std::ostream& out,
                   LineOfFrame line_of_frame) {
  finder.push(bytes);
  finder.finish();
  while (const auto stretch = finder.next()) {
    if (!stretch->whole) {
      write_line(out, bad_line(*stretch, stretch->reason));
      continue;
    }
    try {
      write_line(out, line_of_frame(stretch->bytes));
    } catch (const std::exception& error) {
      write_line(out, bad_line(*stretch, error.what()));
    }
  }
}

}  // namespace scanway::tools
