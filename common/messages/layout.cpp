#include "common/messages/layout.h"

#include <algorithm>
#include <array>
#include <utility>

#include "common/messages/lcm_text.h"
#include "lcmtypes/all_types.h"

namespace scanway {

namespace {

// LCM's hash of a type (lcmgen.c, lcm_struct_hash): of the names and the wire types of its members, and of nothing
// else.
class Hash {
 public:
  void add(char c) {
    const auto sign_extended = static_cast<std::uint64_t>(static_cast<std::int64_t>(value_) >> 55);
    value_ = ((value_ << 8) ^ sign_extended) + static_cast<std::uint64_t>(static_cast<signed char>(c));
  }
  void add(std::string_view text) {
    add(static_cast<char>(text.size()));
    for (const char c : text) add(c);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0x12345678;
};

std::uint64_t hash_of_members(const Layout& layout) {
  Hash hash;
  for (const Layout::Member& member : layout.members) {
    hash.add(member.name);
    if (member.kind != Layout::Kind::nested) hash.add(member.type);
    hash.add(static_cast<char>(member.dimensions.size()));
    for (const Layout::Dimension& dimension : member.dimensions) {
      hash.add(static_cast<char>(dimension.length_member < 0 ? 0 : 1));
      hash.add(dimension.text);
    }
  }
  return hash.value();
}

std::int64_t fingerprint_of(const Layout& layout) {
  std::uint64_t sum = hash_of_members(layout);
  for (const Layout::Member& member : layout.members) {
    if (member.nested != nullptr) sum += static_cast<std::uint64_t>(fingerprint_of(*member.nested));
  }
  return static_cast<std::int64_t>((sum << 1) + (sum >> 63));
}

std::vector<Layout> read_layouts() {
  std::vector<Layout> all;
  for (const std::string_view text : lcmtypes::kTexts) {
    for (Layout& layout : parse_lcm_text(text)) all.push_back(std::move(layout));
  }
  std::sort(all.begin(), all.end(), [](const Layout& a, const Layout& b) { return a.name < b.name; });
  link_nested(all);
  for (Layout& layout : all) layout.hash = fingerprint_of(layout);
  return all;
}

}  // namespace

std::span<const Layout> layouts() {
  static const std::vector<Layout> all = read_layouts();
  return all;
}

const Layout* find_layout(std::string_view name) {
  const auto all = layouts();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Layout& layout) { return layout.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const Layout* find_layout(std::int64_t hash) {
  const auto all = layouts();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Layout& layout) { return layout.hash == hash; });
  return found == all.end() ? nullptr : &*found;
}

const Layout* layout_on(const Channel& channel, std::span<const std::uint8_t> message) {
  const Layout* const told = find_layout(fingerprint(message));
  return told != nullptr && channel.carries(told->name) ? told : find_layout(channel.type);
}

}  // namespace scanway
