#include "common/config/yaml_document.h"

#include <algorithm>

#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {
namespace {

constexpr std::size_t kLongest = 1 << 20;  // no configuration is longer, and yaml-cpp is slow

[[noreturn]] void fail(const std::string& name, const std::string& what) {
  throw InputError(printable(name) + ": " + what);
}

/// The bytes of the UTF-8 sequence that begins with `first`; 0 when none does.
std::size_t sequence_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && c != '\r' && c != '\t') || byte == 0x7F;
}

/// The line of the first byte that is no text in UTF-8; 0 when all is well.
std::ptrdiff_t line_that_is_no_text(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(static_cast<unsigned char>(text[i]));
    const std::string_view tail = text.substr(i, length).substr(length > 0 ? 1 : 0);
    if (length == 0 || tail.size() + 1 < length || !std::ranges::all_of(tail, is_continuation) || is_control(text[i])) {
      return 1 + std::ranges::count(text.substr(0, i), '\n');
    }
    i += length;
  }
  return 0;
}

}  // namespace

int line_of(const YAML::Node& node) { return node.Mark().is_null() ? 0 : node.Mark().line + 1; }

YAML::Node yaml_mapping(std::string_view text, const std::string& name) {
  if (text.size() > kLongest) fail(name, "is longer than 1 MiB: not a configuration");
  if (const auto line = line_that_is_no_text(text); line > 0) {
    fail(name, "is no text in UTF-8 (line " + std::to_string(line) + "): write it with a text editor");
  }
  std::vector<YAML::Node> documents;
  try {
    documents = YAML::LoadAll(std::string(text));
  } catch (const YAML::Exception& e) {
    const std::string line = e.mark.is_null() ? "" : " (line " + std::to_string(e.mark.line + 1) + ")";
    fail(name, "is not valid YAML" + line + ": " + printable(e.msg));
  }
  if (documents.size() > 1) fail(name, "holds more than one YAML document: leave one");
  if (documents.empty() || documents[0].IsNull()) return YAML::Node(YAML::NodeType::Map);
  if (!documents[0].IsMap()) fail(name, "is no list of `key: value` lines");
  return documents[0];
}

}  // namespace scanway
