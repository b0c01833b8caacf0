#include "common/messages/lcm_text.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace scanway {

namespace {

using Kind = Layout::Kind;

constexpr std::pair<std::string_view, Kind> kPrimitives[] = {
    {"int8_t", Kind::int8},   {"int16_t", Kind::int16},  {"int32_t", Kind::int32},
    {"int64_t", Kind::int64}, {"byte", Kind::int8},      {"boolean", Kind::int8},
    {"float", Kind::float32}, {"double", Kind::float64}, {"string", Kind::string},
};

// The words and marks of a .lcm file, without its comments.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(text) { advance(); }

  bool at_end() const { return token_.empty(); }
  std::string take() {
    if (at_end()) throw std::invalid_argument("a .lcm file ends too early");
    const std::string taken(token_);
    advance();
    return taken;
  }
  bool take_if(std::string_view expected) {
    if (token_ != expected) return false;
    advance();
    return true;
  }
  void expect(std::string_view expected) {
    if (!take_if(expected)) {
      throw std::invalid_argument("a .lcm file has '" + std::string(token_) + "' in place of '" +
                                  std::string(expected) + "'");
    }
  }

 private:
  static bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; }

  void skip(std::string_view closing) {
    const std::size_t end = text_.find(closing);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + closing.size());
  }
  void advance() {
    while (!text_.empty()) {
      if (text_.starts_with("//"))
        skip("\n");
      else if (text_.starts_with("/*"))
        skip("*/");
      else if (std::isspace(static_cast<unsigned char>(text_[0])))
        text_.remove_prefix(1);
      else
        break;
    }
    std::size_t length = text_.empty() ? 0 : 1;
    if (length == 1 && in_word(text_[0])) {
      while (length < text_.size() && in_word(text_[length])) ++length;
    }
    token_ = text_.substr(0, length);
    text_.remove_prefix(length);
  }

  std::string_view text_;
  std::string_view token_;
};

Layout::Dimension read_dimension(Tokens& tokens, const Layout& layout) {
  Layout::Dimension dimension;
  dimension.text = tokens.take();
  tokens.expect("]");
  if (std::isdigit(static_cast<unsigned char>(dimension.text[0]))) {
    dimension.size = std::stoll(dimension.text, nullptr, 0);
    return dimension;
  }
  for (std::size_t i = 0; i < layout.members.size(); ++i) {
    if (layout.members[i].name == dimension.text) dimension.length_member = static_cast<int>(i);
  }
  if (dimension.length_member < 0) throw std::invalid_argument("no length member '" + dimension.text + "'");
  return dimension;
}

void read_members(Tokens& tokens, const std::string& package, Layout& layout) {
  std::string type = tokens.take();
  const auto primitive = std::find_if(std::begin(kPrimitives), std::end(kPrimitives),
                                      [&](const auto& entry) { return entry.first == type; });
  const Kind kind = primitive == std::end(kPrimitives) ? Kind::nested : primitive->second;
  if (kind == Kind::nested && type.find('.') == std::string::npos) type = package + "." + type;
  do {
    Layout::Member member;
    member.type = type;
    member.kind = kind;
    member.name = tokens.take();
    while (tokens.take_if("[")) member.dimensions.push_back(read_dimension(tokens, layout));
    layout.members.push_back(std::move(member));
  } while (tokens.take_if(","));
  tokens.expect(";");
}

Layout read_struct(Tokens& tokens, const std::string& package) {
  Layout layout;
  layout.name = package + "." + tokens.take();
  tokens.expect("{");
  while (!tokens.take_if("}")) {
    if (tokens.take_if("const")) {  // Not on the wire.
      while (!tokens.take_if(";")) tokens.take();
    } else {
      read_members(tokens, package, layout);
    }
  }
  if (layout.members.size() > Layout::kMaxMembers) throw std::invalid_argument(layout.name + " has too many members");
  return layout;
}

void refuse_recursion(const Layout& layout, int depth) {
  if (depth > Layout::kMaxDepth) throw std::invalid_argument(layout.name + " is nested too deep");
  for (const Layout::Member& member : layout.members) {
    if (member.nested != nullptr) refuse_recursion(*member.nested, depth + 1);
  }
}

}  // namespace

std::vector<Layout> parse_lcm_text(std::string_view text) {
  Tokens tokens(text);
  std::vector<Layout> layouts;
  std::string package;
  while (!tokens.at_end()) {
    if (tokens.take_if("package")) {
      package = tokens.take();
      tokens.expect(";");
    } else {
      tokens.expect("struct");
      layouts.push_back(read_struct(tokens, package));
    }
  }
  return layouts;
}

void link_nested(std::vector<Layout>& layouts) {
  for (Layout& layout : layouts) {
    for (Layout::Member& member : layout.members) {
      if (member.kind != Kind::nested) continue;
      const auto found =
          std::find_if(layouts.begin(), layouts.end(), [&](const Layout& other) { return other.name == member.type; });
      if (found == layouts.end()) throw std::invalid_argument(layout.name + ": no type " + member.type);
      member.nested = &*found;
    }
  }
  for (const Layout& layout : layouts) refuse_recursion(layout, 0);
}

}  // namespace scanway
