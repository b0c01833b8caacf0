#pragma once

#include <string>
#include <vector>

#include "modules/schunk_bridge/core/listener.h"
#include "modules/schunk_bridge/core/reply.h"

namespace scanway::schunk {

/// "01 92"
std::string hex_of(std::span<const std::uint8_t> bytes);
/// The names of the parts that a state of that mask holds.
std::vector<std::string> names_in_mask(std::uint8_t mask);
/// What a reply says, part by part; empty for Malformed.
std::vector<Field> fields_of(const Message& message, const Reply& reply);
/// What a request asks for, part by part. Returns nothing when its length fits no form of the command.
std::optional<std::vector<Field>> fields_of_request(const Message& message, UnitSystem units);

}  // namespace scanway::schunk
