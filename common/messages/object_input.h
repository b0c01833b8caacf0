#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/messages/codec.h"
#include "common/messages/object_assembler.h"

namespace scanway {

/// The objects of one channel as a node takes them: pieces in, messages of LCM type T out. Whatever is refused on the
/// way, the piece, the object or what the node makes of it, is counted here.
template <class T>
class ObjectInput {
 public:
  /// Calls `use(message, object)` if the piece completes an object; a BadMessage that it throws counts too.
  template <class Use>
  void take(std::span<const std::uint8_t> piece, const Use& use) {
    try {
      if (std::optional<Object> object = assembler_.add(decode<piece_t>(piece))) {
        use(decode<T>(object->bytes), *object);
      }
    } catch (const BadMessage&) {
      ++bad_messages_;
    }
  }
  void give_up_all() { assembler_.give_up_all(); }

  std::int64_t bad_messages() const { return bad_messages_; }
  const AssemblerCounters& counters() const { return assembler_.counters(); }
  std::vector<IncompleteObject> incomplete() const { return assembler_.incomplete(); }

 private:
  ObjectAssembler assembler_;
  std::int64_t bad_messages_ = 0;
};

}  // namespace scanway
