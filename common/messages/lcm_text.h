#pragma once

#include <string_view>
#include <vector>

#include "common/messages/layout.h"

namespace scanway {

/// The types that the text of a .lcm file declares, without their fingerprints; nested types not linked yet. Throws
/// std::invalid_argument for what LCM's grammar does not know.
std::vector<Layout> parse_lcm_text(std::string_view text);

/// Points the members of nested types to their layouts among `layouts`. Throws std::invalid_argument when one is not
/// there, or holds itself.
void link_nested(std::vector<Layout>& layouts);

}  // namespace scanway
