#include <array>
#include <bit>
#include <limits>

#include "common/messages/digest.h"
#include "common/messages/layout.h"
#include "common/messages/wire_width.h"

namespace scanway {

namespace {

using Kind = Layout::Kind;

// Big-endian and signed, as lengths are.
std::int64_t integer(std::span<const std::uint8_t> bytes) {
  std::uint64_t value = (bytes[0] & 0x80) != 0 ? ~std::uint64_t{0} : 0;
  for (const std::uint8_t byte : bytes) value = value << 8 | byte;
  return static_cast<std::int64_t>(value);
}

/// Walks over a message as its layout says, and stops where the two disagree.
class Walker {
 public:
  explicit Walker(std::span<const std::uint8_t> rest) : rest_(rest) {}

  bool walk(const Layout& layout) {
    std::array<std::int64_t, Layout::kMaxMembers> lengths{};  // By member; of those that may be lengths.
    for (std::size_t i = 0; i < layout.members.size(); ++i) {
      const Layout::Member& member = layout.members[i];
      if (!walk_member(member, lengths, lengths[i])) {
        if (where_.empty()) where_ = layout.name + "." + member.name;
        return false;
      }
    }
    return true;
  }

  std::string fault() const { return where_ + ": " + why_; }
  std::size_t left() const { return rest_.size(); }

 private:
  using Lengths = std::array<std::int64_t, Layout::kMaxMembers>;

  bool fail(std::string why) {
    why_ = std::move(why);
    return false;
  }

  bool walk_member(const Layout::Member& member, const Lengths& lengths, std::int64_t& value) {
    if (member.dimensions.empty() && is_integer(member.kind)) {
      if (rest_.size() < wire_width(member.kind)) return fail_short();
      value = integer(rest_.first(wire_width(member.kind)));
    }
    std::uint64_t count = 1;
    for (const Layout::Dimension& dimension : member.dimensions) {
      const std::int64_t size =
          dimension.length_member < 0 ? dimension.size : lengths[static_cast<std::size_t>(dimension.length_member)];
      if (size < 0) return fail("a negative length, " + std::to_string(size));
      // No element is shorter than a byte. Both factors are below 2^63, and the first is below 2^31.
      if (static_cast<std::uint64_t>(size) > rest_.size()) return fail_long(size);
      count *= static_cast<std::uint64_t>(size);
      if (count > rest_.size()) return fail_long(static_cast<std::int64_t>(count));
    }
    return walk_elements(member, count);
  }

  bool walk_elements(const Layout::Member& member, std::uint64_t count) {
    if (member.kind != Kind::string && member.kind != Kind::nested) {
      return count * wire_width(member.kind) <= rest_.size() ? advance(count * wire_width(member.kind)) : fail_short();
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      if (!(member.kind == Kind::string ? walk_string() : walk(*member.nested))) return false;
    }
    return true;
  }

  bool walk_string() {
    if (rest_.size() < 4) return fail_short();
    const std::int64_t length = integer(rest_.first(4));  // With the zero byte at its end.
    advance(4);
    if (length < 1) return fail("a string of length " + std::to_string(length));
    if (static_cast<std::uint64_t>(length) > rest_.size()) return fail_long(length);
    const auto text = rest_.first(static_cast<std::size_t>(length));
    for (std::size_t i = 0; i < text.size(); ++i) {
      if ((text[i] == 0) != (i + 1 == text.size())) return fail("a string that does not end with its only zero byte");
    }
    return advance(text.size());
  }

  static bool is_integer(Kind kind) { return kind <= Kind::int64 && kind != Kind::float32; }
  bool advance(std::size_t bytes) {
    rest_ = rest_.subspan(bytes);
    return true;
  }
  bool fail_short() { return fail("cut off"); }
  bool fail_long(std::int64_t length) {
    return fail("length " + std::to_string(length) + ", but only " + std::to_string(rest_.size()) + " bytes follow");
  }

  std::span<const std::uint8_t> rest_;
  std::string where_;
  std::string why_;
};

}  // namespace

std::int64_t fingerprint(std::span<const std::uint8_t> message) {
  return message.size() < 8 ? 0 : integer(message.first(8));
}

std::string find_fault(const Layout& layout, std::span<const std::uint8_t> message) {
  if (message.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) return "2 GB or more";
  if (message.size() < 8) return layout.name + ": cut off";
  if (fingerprint(message) != layout.hash) {
    const Layout* const other = find_layout(fingerprint(message));
    return "not " + layout.name + " but " +
           (other != nullptr ? other->name : "fingerprint " + hex(static_cast<std::uint64_t>(fingerprint(message))));
  }
  Walker walker(message.subspan(8));
  if (!walker.walk(layout)) return walker.fault();
  if (walker.left() > 0) return layout.name + ": " + std::to_string(walker.left()) + " bytes too many";
  return {};
}

}  // namespace scanway
