#include "common/config/nearest_key.h"

#include <algorithm>
#include <numeric>

#include "common/config/units.h"

namespace scanway {
namespace {

std::string_view last_part(std::string_view key) { return key.substr(key.rfind('.') + 1); }

/// Levenshtein's distance, with swapped neighbours counted as one change.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

/// How far a written key is from a known one. A key in the wrong section is one change away from its own.
std::size_t changes(std::string_view written, std::string_view known) {
  return std::min(distance(written, known), distance(last_part(written), last_part(known)) + 1);
}

}  // namespace

std::string nearest_key(std::string_view key, const std::vector<std::string>& known) {
  key = key.substr(0, 200);
  std::string nearest;
  std::size_t fewest = std::max<std::size_t>(2, last_part(key).size() / 3) + 1;
  for (const std::string& candidate : known) {
    const std::size_t needed = changes(key, candidate);
    if (needed < fewest) {
      fewest = needed;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string key_with_other_unit(std::string_view key, const std::vector<std::string>& known) {
  for (const std::string& candidate : known) {
    if (unit_of(candidate) && candidate != key && without_unit(candidate) == without_unit(key)) return candidate;
  }
  return {};
}

}  // namespace scanway
