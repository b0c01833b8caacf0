#include "modules/tools/spy/gap_counter.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "common/messages/wire_width.h"

namespace scanway::tools {
namespace {

using Kind = Layout::Kind;

constexpr std::string_view kNumberNames[] = {"line", "seq", "sequence", "sequence_number", "number"};
/// A number that is lower by more is no latecomer but a new numbering; one that is higher by more is, too.
constexpr std::int64_t kNewNumbering = 100'000;
constexpr std::size_t kStepsNeeded = 10;
constexpr std::size_t kStepsKept = 40;
constexpr double kEvenShare = 0.8;
constexpr double kEvenWithin = 0.25;
constexpr double kGapFrom = 1.5;

bool is_integer(Kind kind) { return kind <= Kind::int64; }

}  // namespace

std::optional<std::int64_t> integer_member(const Layout& layout, std::span<const std::uint8_t> message,
                                           std::string_view name) {
  std::size_t offset = sizeof layout.hash;
  for (const Layout::Member& member : layout.members) {
    const std::size_t size = wire_width(member.kind);
    if (size == 0 || !member.dimensions.empty()) return std::nullopt;
    if (member.name == name) {
      if (!is_integer(member.kind)) return std::nullopt;
      const auto bytes = message.subspan(offset, size);
      std::uint64_t value = (bytes[0] & 0x80) != 0 ? ~std::uint64_t{0} : 0;
      for (const std::uint8_t byte : bytes) value = value << 8 | byte;
      return static_cast<std::int64_t>(value);
    }
    offset += size;
  }
  return std::nullopt;
}

void GapCounter::add(const Layout& layout, std::span<const std::uint8_t> message) {
  for (const std::string_view name : kNumberNames) {
    if (const auto number = integer_member(layout, message, name)) return add_number(*number);
  }
  if (const auto utime = integer_member(layout, message, "utime")) add_utime(*utime);
}

std::optional<std::uint64_t> GapCounter::missing() const {
  return numbered_ || even_ ? std::optional(missing_) : std::nullopt;
}

void GapCounter::add_number(std::int64_t number) {
  numbered_ = true;
  // Unsigned: what a message says must not overflow.
  const auto step = static_cast<std::int64_t>(static_cast<std::uint64_t>(number) -
                                              static_cast<std::uint64_t>(last_.value_or(number)));
  const bool new_numbering = step > kNewNumbering || step < -kNewNumbering || (step < 0 && number <= 1);
  if (!new_numbering && step > 1) missing_ += static_cast<std::uint64_t>(step - 1);
  if (!last_ || new_numbering || step > 0) last_ = number;
}

void GapCounter::add_utime(std::int64_t utime) {
  const auto step =
      static_cast<std::int64_t>(static_cast<std::uint64_t>(utime) - static_cast<std::uint64_t>(last_.value_or(utime)));
  last_ = utime;
  if (step <= 0) return;
  if (const auto usual = usual_step()) {
    even_ = true;
    const double steps = static_cast<double>(step) / *usual;
    if (steps > kGapFrom && steps < static_cast<double>(kNewNumbering)) {
      missing_ += static_cast<std::uint64_t>(std::lround(steps)) - 1;
    }
  }
  steps_.push_back(step);
  if (steps_.size() > kStepsKept) steps_.pop_front();
}

std::optional<double> GapCounter::usual_step() const {
  if (steps_.size() < kStepsNeeded) return std::nullopt;
  std::vector<std::int64_t> steps(steps_.begin(), steps_.end());
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const auto median = static_cast<double>(*middle);
  const auto alike = std::count_if(steps.begin(), steps.end(), [median](std::int64_t step) {
    return std::fabs(static_cast<double>(step) - median) <= kEvenWithin * median;
  });
  return static_cast<double>(alike) >= kEvenShare * static_cast<double>(steps.size()) ? std::optional(median)
                                                                                      : std::nullopt;
}

}  // namespace scanway::tools
