#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace scanway {

/// The unit at the end of a key: `height_m` is in metres, `sweep_deg` in degrees.
struct Unit {
  std::string_view suffix;  ///< As the key ends, "_deg".
  std::string_view name;    ///< For messages: "degrees".
  long double numerator;    ///< The SI value is the written number times numerator / denominator.
  long double denominator;
};

/// The unit of `key` by its ending; nothing for a key without one.
std::optional<Unit> unit_of(std::string_view key);

/// `key` without the ending that says its unit.
std::string_view without_unit(std::string_view key);

/// The SI value of the number `text`, rounded once; nothing if `text` is no finite decimal number.
std::optional<double> si_from_text(std::string_view text, const std::optional<Unit>& unit);

/// The shortest text that si_from_text() turns into `value` again, to the last bit.
std::string text_from_si(double value, const std::optional<Unit>& unit);

}  // namespace scanway
