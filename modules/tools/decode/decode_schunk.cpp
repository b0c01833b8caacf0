#include "modules/tools/decode/decode_schunk.h"

#include <algorithm>
#include <iostream>
#include <vector>

#include "common/files/read_file.h"
#include "modules/schunk_bridge/core/candump.h"
#include "modules/schunk_bridge/core/fields.h"
#include "modules/schunk_bridge/core/listener.h"
#include "modules/tools/decode/decode_stream.h"

namespace scanway::tools {
namespace {

using Json = nlohmann::ordered_json;

/// The line of `text` that begins at `offset`, without its end.
std::string_view line_at(std::string_view text, std::size_t offset) {
  const std::string_view rest = text.substr(offset);
  return rest.substr(0, rest.find('\n'));
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = line.find(separator);
    parts.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return parts;
    line.remove_prefix(end + 1);
  }
}

/// Which columns of a CSV hold a frame.
struct Columns {
  std::size_t can_id = 0, data = 0;

  /// From the line of names; nothing if that does not name both.
  static std::optional<Columns> find(std::string_view names) {
    while (!names.empty() && names.back() == '\r') names.remove_suffix(1);
    const auto parts = split(names, ',');
    const auto id = std::find(parts.begin(), parts.end(), "can_id"),
               data = std::find(parts.begin(), parts.end(), "data");
    if (id == parts.end() || data == parts.end()) return std::nullopt;
    return Columns{static_cast<std::size_t>(id - parts.begin()), static_cast<std::size_t>(data - parts.begin())};
  }

  /// The row in cansend's form: "501#0192"; empty if it lacks a column.
  std::string compact(std::string_view row) const {
    const auto parts = split(row, ',');
    if (parts.size() <= std::max(can_id, data)) return {};
    std::string_view id = parts[can_id];
    if (id.starts_with("0x")) id.remove_prefix(2);
    std::string text(id);
    text += '#';
    std::copy_if(parts[data].begin(), parts[data].end(), std::back_inserter(text), [](char c) { return c != ' '; });
    return text;
  }
};

template <class T>
Json json_of(const T& value) {
  return value;
}
Json json_of(std::monostate) { return nullptr; }

Json line_of(const schunk::Reading& reading, std::size_t offset) {
  Json line = {{"type", reading.type}};
  if (!reading.kind.empty()) line["kind"] = reading.kind;
  if (reading.module != 0) line["module"] = reading.module;
  if (reading.utime) line["utime"] = *reading.utime;
  line["offset"] = offset;
  for (const schunk::Field& field : reading.fields) {
    std::visit([&](const auto& value) { line[field.name] = json_of(value); }, field.value);
  }
  return line;
}

/// A line that holds no data frame of 11 bits, but is a line of a recording all the same.
Json line_of_other(const schunk::CanLine& frame, std::size_t offset) {
  using Kind = schunk::CanLine::Kind;
  const char* type = frame.kind == Kind::error      ? "CAN error frame"
                     : frame.kind == Kind::extended ? "extended frame"
                     : frame.kind == Kind::remote   ? "remote frame"
                                                    : "CAN FD frame";
  Json line = {{"type", type}};
  if (frame.utime) line["utime"] = *frame.utime;
  line["offset"] = offset;
  if (frame.kind == Kind::error) {
    line["errors"] = schunk::describe_error_frame(frame.id);
  } else {
    line["id"] = frame.id;
  }
  line["bytes"] = schunk::hex_of(frame.frame.bytes());
  return line;
}

/// Reads a recording line by line; frames are numbered by the offset of their line.
class Decoder {
 public:
  Decoder(std::string_view text, std::ostream& out) : text_(text), out_(out) {}

  void run() {
    const std::optional<Columns> columns = Columns::find(line_at(text_, 0));
    for (std::size_t offset = 0; offset < text_.size();) {
      const std::string_view line = line_at(text_, offset);
      if (!is_blank(line) && !(columns && offset == 0)) {
        const std::string compact = columns ? columns->compact(line) : std::string();
        take(columns ? std::string_view(compact) : line, offset);
      }
      offset += line.size() + 1;
    }
    for (const auto& bad : listener_.end()) write_bad(bad.frames, bad.reason);
  }

 private:
  void take(std::string_view line, std::size_t offset) {
    const auto frame = schunk::parse_can_line(line);
    if (!frame) {
      write_bad({offset}, "this line is no CAN frame in candump's forms");
    } else if (frame->kind != schunk::CanLine::Kind::data) {
      write_line(out_, line_of_other(*frame, offset));
    } else {
      const auto result = listener_.add(frame->frame, offset, frame->utime);
      for (const auto& bad : result.bad) write_bad(bad.frames, bad.reason);
      for (const auto& reading : result.readings) write_line(out_, line_of(reading, reading.frames.front()));
    }
  }

  void write_bad(const std::vector<std::size_t>& offsets, const std::string& reason) {
    for (const std::size_t offset : offsets) {
      write_line(out_,
                 {{"type", "bad"}, {"offset", offset}, {"length", line_at(text_, offset).size()}, {"reason", reason}});
    }
  }

  std::string_view text_;
  std::ostream& out_;
  schunk::Listener listener_;
};

}  // namespace

void decode_schunk(std::string_view text, std::ostream& out) { Decoder(text, out).run(); }

int run_decode_schunk(const std::string& file) {
  decode_schunk(read_file(file), std::cout);
  return 0;
}

}  // namespace scanway::tools
