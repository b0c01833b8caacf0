#include "modules/tools/spy/message_json.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

#include <fmt/format.h>

#include "common/files/printable.h"

namespace scanway::tools {
namespace {

using Json = nlohmann::ordered_json;
using Kind = Layout::Kind;
constexpr const char* kMore = "more";

/// The double that is written like the float: 0.1, not 0.10000000149011612.
double as_written(float value) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  double same = value;
  std::from_chars(text.data(), written.ptr, same);
  return same;
}

/// Reads a message that was checked, from its front to its end.
class Reader {
 public:
  Reader(std::span<const std::uint8_t> rest, std::size_t most_elements) : rest_(rest), most_elements_(most_elements) {}

  Json read(const Layout& layout) {
    Json fields = Json::object();
    std::array<std::int64_t, Layout::kMaxMembers> lengths{};
    for (std::size_t i = 0; i < layout.members.size(); ++i) {
      const Layout::Member& member = layout.members[i];
      Json value = read_dimension(member, lengths, 0);
      if (value.is_number_integer()) lengths[i] = value.get<std::int64_t>();
      fields[member.name] = std::move(value);
    }
    return fields;
  }

 private:
  using Lengths = std::array<std::int64_t, Layout::kMaxMembers>;

  Json read_dimension(const Layout::Member& member, const Lengths& lengths, std::size_t dimension) {
    if (dimension == member.dimensions.size()) return read_one(member);
    const Layout::Dimension& size = member.dimensions[dimension];
    const auto count = static_cast<std::size_t>(
        size.length_member < 0 ? size.size : lengths[static_cast<std::size_t>(size.length_member)]);
    Json values = Json::array();
    for (std::size_t i = 0; i < count; ++i) {
      Json value = read_dimension(member, lengths, dimension + 1);
      if (i < most_elements_) values.push_back(std::move(value));
    }
    if (count > most_elements_) values.push_back(Json{{kMore, count - most_elements_}});
    return values;
  }

  Json read_one(const Layout::Member& member) {
    switch (member.kind) {
      case Kind::int8:
        if (member.type == "boolean") return take(1) != 0;
        return member.type == "byte" ? Json(take(1)) : Json(static_cast<std::int8_t>(take(1)));
      case Kind::int16:
        return static_cast<std::int16_t>(take(2));
      case Kind::int32:
        return static_cast<std::int32_t>(take(4));
      case Kind::int64:
        return static_cast<std::int64_t>(take(8));
      case Kind::float32:
        return as_written(std::bit_cast<float>(static_cast<std::uint32_t>(take(4))));
      case Kind::float64:
        return std::bit_cast<double>(take(8));
      case Kind::string:
        return read_string();
      case Kind::nested:
        break;
    }
    return read(*member.nested);
  }

  Json read_string() {
    const auto length = static_cast<std::size_t>(take(4));  // With the zero byte at its end.
    const std::string text(reinterpret_cast<const char*>(rest_.data()), length - 1);
    rest_ = rest_.subspan(length);
    return text;
  }

  std::uint64_t take(std::size_t bytes) {
    std::uint64_t value = 0;
    for (const std::uint8_t byte : rest_.first(bytes)) value = value << 8 | byte;
    rest_ = rest_.subspan(bytes);
    return value;
  }

  std::span<const std::uint8_t> rest_;
  const std::size_t most_elements_;
};

std::string one_line(const Json& value) {
  if (value.is_string()) return fmt::format("\"{}\"", printable(value.get_ref<const std::string&>()));
  if (value.is_number_float()) return fmt::format("{:.9g}", value.get<double>());
  if (value.is_object() && value.size() == 1 && value.contains(kMore)) {
    return fmt::format("... {} more", value[kMore].get<std::size_t>());
  }
  std::string parts;
  const auto add = [&parts](const std::string& part) { parts += (parts.empty() ? "" : ", ") + part; };
  if (value.is_object()) {
    for (const auto& [name, field] : value.items()) add(name + " " + one_line(field));
    return parts;
  }
  if (!value.is_array()) return value.dump();
  for (const Json& element : value) add(one_line(element));
  return "[" + parts + "]";
}

bool holds_objects(const Json& value) { return value.is_array() && !value.empty() && value.front().is_object(); }

}  // namespace

Json message_json(const Layout& layout, std::span<const std::uint8_t> message, std::size_t most_elements) {
  return Reader(message.subspan(sizeof layout.hash), most_elements).read(layout);
}

std::string message_text(const Json& message) {
  std::size_t width = 0;
  for (const auto& [name, value] : message.items()) width = std::max(width, name.size());
  std::string text;
  for (const auto& [name, value] : message.items()) {
    if (!holds_objects(value)) {
      text += fmt::format("  {:<{}}  {}\n", name, width, one_line(value));
      continue;
    }
    text += fmt::format("  {}\n", name);
    for (const Json& element : value) text += fmt::format("    {}\n", one_line(element));
  }
  return text;
}

}  // namespace scanway::tools
