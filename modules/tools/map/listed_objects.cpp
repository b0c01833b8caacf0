#include "modules/tools/map/listed_objects.h"

#include <algorithm>
#include <utility>

namespace scanway::tools {

void ListedObjects::list(List list, std::int64_t version) {
  if (version < version_) return;
  list_ = std::move(list);
  version_ = version;
}

void ListedObjects::put(const Object& object) {
  Object& known = here_[object.key];
  if (object.version >= known.version) known = object;
}

bool ListedObjects::is_here(const List::value_type& entry) const {
  const auto known = here_.find(entry.first);
  return known != here_.end() && static_cast<std::int64_t>(known->second.digest) == entry.second;
}

std::size_t ListedObjects::lacking() const {
  return static_cast<std::size_t>(
      std::count_if(list_.begin(), list_.end(), [this](const auto& entry) { return !is_here(entry); }));
}

std::vector<const std::vector<std::uint8_t>*> ListedObjects::objects() const {
  std::vector<const std::vector<std::uint8_t>*> objects;
  for (const auto& entry : list_) {
    if (is_here(entry)) objects.push_back(&here_.at(entry.first).bytes);
  }
  return objects;
}

}  // namespace scanway::tools
