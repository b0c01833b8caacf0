#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scanway {

/// What a protocol says of the bytes that begin at one place of a stream.
struct FrameProbe {
  enum class Kind : std::uint8_t {
    no_frame,    ///< No frame begins here.
    unfinished,  ///< A frame may begin here; more bytes will tell.
    broken,      ///< A frame seems to begin here, and is not whole: see `reason`.
    whole,       ///< A frame of `length` bytes begins here, and its checksum is right.
  };
  Kind kind = Kind::no_frame;
  std::size_t length = 0;
  std::string reason;

  static FrameProbe none() { return {}; }
  static FrameProbe unfinished() { return {Kind::unfinished, 0, {}}; }
  static FrameProbe broken(std::string why) { return {Kind::broken, 0, std::move(why)}; }
  static FrameProbe whole(std::size_t length) { return {Kind::whole, length, {}}; }
};

/// A stretch of a stream: one whole frame, or bytes that belong to none.
struct Stretch {
  bool whole = false;
  std::uint64_t offset = 0;  ///< In the stream.
  std::uint64_t length = 0;
  std::vector<std::uint8_t> bytes;  ///< Of a whole frame.
  std::string reason;               ///< Why the bytes are no frame.
};

/// Finds the whole frames of a byte stream that comes in any pieces, and of which bytes may be missing, doubled or
/// wrong. After a broken frame the search goes on one byte further, so a good frame is never lost to a bad one. A frame
/// inside of which two whole frames follow each other is none: its length is wrong. So one that waits for bytes that
/// will not come does not hold up those after it. No byte is in two stretches, and all are in one.
class FrameFinder {
 public:
  /// Says what begins at bytes[0]. It is never called without bytes.
  using Rule = FrameProbe (*)(std::span<const std::uint8_t> bytes);

  /// Frames begin with the byte `first`.
  FrameFinder(Rule rule, std::uint8_t first) : rule_(rule), first_(first) {}

  void push(std::span<const std::uint8_t> bytes);
  /// No more bytes will come: what waits for more is broken.
  void finish() { finished_ = true; }
  /// The next stretch in the order of the stream; nothing until more bytes come.
  std::optional<Stretch> next();

  /// Bytes that belong to no frame, so far.
  std::uint64_t bad_bytes() const { return bad_bytes_; }

 private:
  std::span<const std::uint8_t> waiting() const { return std::span(buffer_).subspan(begin_); }
  std::size_t find_first(std::span<const std::uint8_t> bytes, std::size_t from) const;
  bool two_frames_inside(std::span<const std::uint8_t> bytes) const;
  FrameProbe probe() const;
  void reject(std::size_t count, const std::string& reason);
  Stretch take_bad();
  Stretch take_frame(std::size_t length);

  Rule rule_;
  std::uint8_t first_;
  bool finished_ = false;
  std::vector<std::uint8_t> buffer_;
  std::size_t begin_ = 0;     // Of what waits, in the buffer.
  std::uint64_t offset_ = 0;  // Of what waits, in the stream.
  std::uint64_t bad_bytes_ = 0;
  Stretch bad_;  // The bytes before what waits that belong to no frame.
};

}  // namespace scanway
