#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scanway {

/// The known key (dotted, "body.height_m") that `key` was most probably meant to be; empty when none is near.
std::string nearest_key(std::string_view key, const std::vector<std::string>& known);

/// The known key that differs from `key` in its unit alone; empty when there is none.
std::string key_with_other_unit(std::string_view key, const std::vector<std::string>& known);

}  // namespace scanway
