#pragma once

#include <span>
#include <vector>

#include "modules/xsens_bridge/core/item.h"

namespace scanway::xsens {

/// The items of an MTData2 message, in its order. Items that no sheet lists, or whose size fits nothing that they could
/// hold, are named "unknown" and keep their bytes. Throws BadMessage when the items do not fill the data.
std::vector<Item> parse_mtdata2(std::span<const std::uint8_t> data);

}  // namespace scanway::xsens
