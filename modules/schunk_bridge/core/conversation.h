#pragma once

#include <deque>
#include <optional>

#include "common/time/utime.h"
#include "modules/schunk_bridge/core/message.h"
#include "modules/schunk_bridge/core/reply.h"

namespace scanway::schunk {

/// A request and what became of it.
struct Asked {
  Message message;
  bool needed = true;  ///< Without an answer the module counts as lost.
  int tries_left = 0;
  Utime patience = 0;  ///< How long an answer may take.
  std::optional<Utime> sent;
};

/// Asks one module one thing after the other, each when the one before is answered, and again when no answer comes.
class Conversation {
 public:
  void ask(Message message, bool needed = true);
  /// Before everything else, which is dropped: for stops.
  void urge(Message message);
  void clear();
  /// Drops everything but a stop.
  void clear_unless_urgent() {
    if (!urgent_) clear();
  }

  /// What is to be sent now.
  std::optional<CanFrame> next_frame(Utime now);
  /// Something urgent waits to be sent.
  bool urgent() const { return !queue_.empty() && urgent_ && !queue_.front().sent; }
  bool idle() const { return queue_.empty() && frames_.empty(); }

  /// The request that a message of the module answers, if it does.
  std::optional<Asked> answered_by(const Message& message, const Reply& reply);
  /// The request whose last try is over without an answer, if there is one.
  std::optional<Asked> given_up(Utime now);

 private:
  Asked take_front();

  std::deque<Asked> queue_;  // The front one is sent, or the next to be.
  std::deque<CanFrame> frames_;
  bool urgent_ = false;  // The front one is.
};

}  // namespace scanway::schunk
