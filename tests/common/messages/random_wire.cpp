#include "tests/common/messages/random_wire.h"

#include <algorithm>
#include <string>

namespace scanway::test {

namespace {

using Kind = Layout::Kind;

class Writer {
 public:
  Writer(Random& random, std::int64_t max_length) : random_(random), max_length_(max_length) {}

  void write(const Layout& layout) {
    std::vector<std::int64_t> values(layout.members.size());
    for (std::size_t i = 0; i < layout.members.size(); ++i) {
      const Layout::Member& member = layout.members[i];
      std::int64_t count = 1;
      for (const auto& dimension : member.dimensions) {
        count *=
            dimension.length_member < 0 ? dimension.size : values[static_cast<std::size_t>(dimension.length_member)];
      }
      const bool is_length = std::any_of(layout.members.begin(), layout.members.end(), [&](const auto& other) {
        return std::any_of(other.dimensions.begin(), other.dimensions.end(),
                           [&](const auto& dimension) { return dimension.length_member == static_cast<int>(i); });
      });
      if (is_length) values[i] = static_cast<std::int64_t>(random_.below(static_cast<std::uint64_t>(max_length_) + 1));
      for (std::int64_t k = 0; k < count; ++k) element(member, is_length ? &values[i] : nullptr);
    }
  }

  void big_endian(std::uint64_t value, int width) {
    for (int i = width - 1; i >= 0; --i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  void element(const Layout::Member& member, const std::int64_t* fixed) {
    switch (member.kind) {
      case Kind::int8:
        return number(1, fixed);
      case Kind::int16:
        return number(2, fixed);
      case Kind::int32:
      case Kind::float32:
        return number(4, fixed);
      case Kind::int64:
      case Kind::float64:
        return number(8, fixed);
      case Kind::string:
        return text();
      case Kind::nested:
        return write(*member.nested);
    }
  }

  void number(int width, const std::int64_t* fixed) {
    constexpr std::uint64_t kEdges[] = {0, ~std::uint64_t{0}, 0x8000000000000000U, 0x7FF8000000000000U,
                                        0x7FC000007FC00000U};
    const std::uint64_t pick = random_.below(10);
    const std::uint64_t value = fixed != nullptr ? static_cast<std::uint64_t>(*fixed)
                                : pick < 5       ? kEdges[pick]
                                                 : random_.next();
    big_endian(value, width);
  }

  void text() {
    const std::uint64_t length = random_.below(static_cast<std::uint64_t>(max_length_) + 1);
    big_endian(length + 1, 4);
    for (std::uint64_t i = 0; i < length; ++i) bytes_.push_back(static_cast<std::uint8_t>(1 + random_.below(255)));
    bytes_.push_back(0);
  }

  Random& random_;
  std::int64_t max_length_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::vector<std::uint8_t> random_wire(const Layout& layout, Random& random, std::int64_t max_length) {
  Writer writer(random, max_length);
  writer.big_endian(static_cast<std::uint64_t>(layout.hash), 8);
  writer.write(layout);
  return writer.take();
}

}  // namespace scanway::test
