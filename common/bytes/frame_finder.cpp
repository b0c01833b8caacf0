#include "common/bytes/frame_finder.h"

#include <algorithm>
#include <utility>

namespace scanway {

void FrameFinder::push(std::span<const std::uint8_t> bytes) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
  begin_ = 0;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

std::optional<Stretch> FrameFinder::next() {
  while (begin_ < buffer_.size()) {
    FrameProbe found = probe();
    switch (found.kind) {
      case FrameProbe::Kind::unfinished:
        return std::nullopt;
      case FrameProbe::Kind::no_frame:
        reject(find_first(waiting(), 1), "no frame begins here");
        break;
      case FrameProbe::Kind::broken:
        if (bad_.length > 0) return take_bad();
        reject(1, found.reason);
        break;
      case FrameProbe::Kind::whole:
        if (bad_.length > 0) return take_bad();
        return take_frame(found.length);
    }
  }
  if (finished_ && bad_.length > 0) return take_bad();
  return std::nullopt;
}

FrameProbe FrameFinder::probe() const {
  FrameProbe found = rule_(waiting());
  const bool unfinished = found.kind == FrameProbe::Kind::unfinished;
  if (!unfinished && found.kind != FrameProbe::Kind::whole) return found;
  if (unfinished && finished_) return FrameProbe::broken("the stream ends within a frame");
  // Also in a whole frame: a checksum of one byte is right by accident once in 256 times.
  if (two_frames_inside(unfinished ? waiting() : waiting().first(found.length))) {
    return FrameProbe::broken("cut short, or its length is wrong: others begin in it");
  }
  return found;
}

std::size_t FrameFinder::find_first(std::span<const std::uint8_t> bytes, std::size_t from) const {
  const auto found = std::find(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(), first_);
  return static_cast<std::size_t>(found - bytes.begin());
}

bool FrameFinder::two_frames_inside(std::span<const std::uint8_t> bytes) const {
  for (std::size_t at = find_first(bytes, 1); at < bytes.size(); at = find_first(bytes, at + 1)) {
    const FrameProbe one = rule_(bytes.subspan(at));
    if (one.kind != FrameProbe::Kind::whole || at + one.length >= bytes.size()) continue;
    if (rule_(bytes.subspan(at + one.length)).kind == FrameProbe::Kind::whole) return true;
  }
  return false;
}

void FrameFinder::reject(std::size_t count, const std::string& reason) {
  if (bad_.length == 0) {
    bad_.offset = offset_;
    bad_.reason = reason;
  }
  bad_.length += count;
  bad_bytes_ += count;
  begin_ += count;
  offset_ += count;
}

Stretch FrameFinder::take_bad() { return std::exchange(bad_, {}); }

Stretch FrameFinder::take_frame(std::size_t length) {
  Stretch frame;
  frame.whole = true;
  frame.offset = offset_;
  frame.length = length;
  frame.bytes.assign(waiting().begin(), waiting().begin() + static_cast<std::ptrdiff_t>(length));
  begin_ += length;
  offset_ += length;
  return frame;
}

}  // namespace scanway
