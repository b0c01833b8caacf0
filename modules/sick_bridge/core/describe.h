#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "modules/sick_bridge/core/cola.h"

namespace scanway::sick {

using FieldValue = std::variant<std::int64_t, double, std::string>;
using Fields = std::vector<std::pair<std::string, FieldValue>>;

/// The parameters of a telegram by name, with what numbers mean in words; what no table lists, or follows what one
/// lists, as `parameters_hex`. Not for scans (scan.h). Throws BadTelegram when the parameters are too short for what
/// the telegram is.
Fields describe(const Telegram& telegram);

/// The code of an sFA telegram. Throws BadTelegram.
unsigned error_code(const Telegram& telegram);

}  // namespace scanway::sick
