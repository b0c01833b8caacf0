#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "common/messages/layout.h"

namespace scanway::tools {

constexpr std::size_t kAllElements = std::numeric_limits<std::size_t>::max();

/// The fields of a message of any type, in the type's own order; nested types are objects, arrays are arrays. Of an
/// array with more than `most_elements`, the rest stands as {"more": how many} at its end. `message` must have passed
/// find_fault() with this layout.
nlohmann::ordered_json message_json(const Layout& layout, std::span<const std::uint8_t> message,
                                    std::size_t most_elements = kAllElements);

/// The same for people: a line a field, arrays of nested types a line an element.
std::string message_text(const nlohmann::ordered_json& message);

}  // namespace scanway::tools
