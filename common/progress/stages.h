#pragma once

#include <string_view>

namespace scanway {

/// Told by a core which stage of its work begins. A core knows no clock; whoever listens may time the stages, draw
/// progress, or do nothing.
class StageListener {
 public:
  virtual ~StageListener() = default;
  /// The stage `name` begins, and whatever stage was under way ends. An empty name: only the end.
  virtual void begin(std::string_view name) = 0;
};

/// begin() for a listener that may be absent.
inline void begin_stage(StageListener* listener, std::string_view name) {
  if (listener != nullptr) listener->begin(name);
}

}  // namespace scanway
