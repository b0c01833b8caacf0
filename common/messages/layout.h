#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/bus/channels.h"

namespace scanway {

/// How an LCM type lies on the wire, read from the text of its .lcm file.
struct Layout {
  enum class Kind : std::uint8_t { int8, int16, int32, int64, float32, float64, string, nested };

  struct Dimension {
    std::int64_t size = 0;   ///< If it is fixed.
    int length_member = -1;  ///< Index of the member that holds it; -1 if it is fixed.
    std::string text;        ///< As the .lcm file writes it.
  };

  struct Member {
    std::string name;
    std::string type;  ///< As the .lcm file writes it, nested types with their package.
    Kind kind = Kind::int8;
    const Layout* nested = nullptr;  ///< If kind is nested.
    std::vector<Dimension> dimensions;
  };

  static constexpr std::size_t kMaxMembers = 32;
  static constexpr int kMaxDepth = 8;

  std::string name;  ///< package.struct
  std::vector<Member> members;
  std::int64_t hash = 0;  ///< LCM's fingerprint, computed from the above.
};

/// Of all types of lcmtypes/.
std::span<const Layout> layouts();

/// By name (package.struct), or by fingerprint: nullptr if there is none. Types with the same members in the same order
/// have the same fingerprint; the first by name is found then.
const Layout* find_layout(std::string_view name);
const Layout* find_layout(std::int64_t hash);

/// By which a message of the channel (an object of it, where it is cut) is to be read: that of the channel's type, or
/// of its other type if the message says so. nullptr if the channel's type is unknown.
const Layout* layout_on(const Channel& channel, std::span<const std::uint8_t> message);

/// The fingerprint that a message begins with; 0 if it is too short to have one.
std::int64_t fingerprint(std::span<const std::uint8_t> message);

/// Why `message` is not exactly one message of this layout, or empty if it is: the fingerprint, every length (nested
/// ones too), every string's end and the total are checked. Allocates nothing by what the message says.
std::string find_fault(const Layout& layout, std::span<const std::uint8_t> message);

}  // namespace scanway
