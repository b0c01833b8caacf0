#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/messages/objects.h"

namespace scanway::tools {

/// Objects that a closing message lists by key and digest, as they come in: what lacks is known as soon as there is a
/// list.
class ListedObjects {
 public:
  using List = std::map<std::string, std::int64_t>;  // Digest by key.

  void list(List list, std::int64_t version);
  void put(const Object& object);

  bool is_listed() const { return version_ > 0; }
  std::int64_t version() const { return version_; }
  std::size_t size() const { return list_.size(); }
  std::size_t lacking() const;
  bool is_whole() const { return is_listed() && lacking() == 0; }
  /// The bytes of what is listed and here, in the order of the keys.
  std::vector<const std::vector<std::uint8_t>*> objects() const;

 private:
  bool is_here(const List::value_type& entry) const;

  List list_;
  std::int64_t version_ = 0;
  std::map<std::string, Object> here_;  // The newest of each key.
};

}  // namespace scanway::tools
