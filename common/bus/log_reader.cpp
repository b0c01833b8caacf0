#include "common/bus/log_reader.h"

#include <algorithm>
#include <cstring>

#include "common/bus/log_format.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {

using namespace log_format;

namespace {

// The end of the event that begins at `offset`, by its lengths alone (not by its sync word); 0 if there can be none.
std::uint64_t end_by_lengths(std::span<const std::uint8_t> file, std::uint64_t offset) {
  if (file.size() - offset < kHeaderBytes) return 0;
  const auto channel_bytes = get<std::uint32_t>(&file[offset + kChannelLengthAt]);
  const auto data_bytes = get<std::uint32_t>(&file[offset + kDataLengthAt]);
  if (channel_bytes == 0 || channel_bytes >= kChannelLengthEnd || data_bytes > INT32_MAX) return 0;
  const std::uint64_t length = kHeaderBytes + std::uint64_t{channel_bytes} + data_bytes;
  return length <= file.size() - offset ? offset + length : 0;
}

// Whether a sync word stands here, or as much of one as there is room for before the end of the file.
bool sync_at(std::span<const std::uint8_t> file, std::uint64_t offset) {
  const std::size_t room = std::min<std::uint64_t>(kSync.size(), file.size() - offset);
  return std::equal(kSync.begin(), kSync.begin() + static_cast<std::ptrdiff_t>(room),
                    file.begin() + static_cast<std::ptrdiff_t>(offset));
}

// The end of the event at `offset`, 0 if it cannot be trusted. A log has no check sums: an event is trusted when where
// it ends the next one begins, or the file ends. The next one's sync word may be damaged, if its lengths are not.
std::uint64_t trusted_end(std::span<const std::uint8_t> file, std::uint64_t offset) {
  if (!sync_at(file, offset)) return 0;
  const std::uint64_t end = end_by_lengths(file, offset);
  if (end == 0 || sync_at(file, end)) return end;
  const std::uint64_t end_of_next = end_by_lengths(file, end);
  return end_of_next != 0 && sync_at(file, end_of_next) ? end : 0;
}

// Where the first event that can be trusted begins at or after `offset`; the file's end if there is none.
std::uint64_t find_trusted(std::span<const std::uint8_t> file, std::uint64_t offset) {
  while (offset < file.size()) {
    const void* const found = std::memchr(&file[offset], kSync[0], file.size() - offset);
    if (found == nullptr) break;
    offset = static_cast<std::uint64_t>(static_cast<const std::uint8_t*>(found) - file.data());
    if (trusted_end(file, offset) != 0) return offset;
    ++offset;
  }
  return file.size();
}

struct Reason {
  std::string text;
  bool cut = false;  // More bytes might have made it a good event.
};

// Why the bytes at `offset` are no event to be trusted.
Reason reason_for(std::span<const std::uint8_t> file, std::uint64_t offset) {
  if (!sync_at(file, offset)) return {"no event begins here"};
  const std::uint64_t room = file.size() - offset;
  if (room < kHeaderBytes) return {"an event's header of 28 bytes has only " + std::to_string(room), true};
  const auto channel_bytes = get<std::uint32_t>(&file[offset + kChannelLengthAt]);
  const auto data_bytes = get<std::uint32_t>(&file[offset + kDataLengthAt]);
  if (channel_bytes == 0 || channel_bytes >= kChannelLengthEnd) {
    return {"an event's channel name has " + std::to_string(channel_bytes) + " bytes"};
  }
  if (data_bytes > INT32_MAX) return {"an event's data has a negative length"};
  const std::uint64_t length = kHeaderBytes + std::uint64_t{channel_bytes} + data_bytes;
  if (length > room) {
    return {"an event of " + std::to_string(length) + " bytes has only " + std::to_string(room), true};
  }
  return {"an event is not followed by another"};
}

}  // namespace

LogReader::LogReader(const std::string& path) : file_(path) {
  const auto file = file_.bytes();
  const auto refuse = [&](const std::string& why) {
    throw InputError(printable(path) + ": not an LCM log: " + why + "; give a log of lcm-logger or scanway");
  };
  if (file.empty()) refuse("it is empty");
  if (!sync_at(file, 0) && find_trusted(file, 0) == file.size()) {
    refuse("there is no event in its " + std::to_string(file.size()) + " bytes");
  }
}

std::optional<LogEvent> LogReader::next() {
  const auto file = file_.bytes();
  if (offset_ == file.size()) return std::nullopt;
  std::uint64_t end = trusted_end(file, offset_);
  if (end == 0) {
    const std::uint64_t found = find_trusted(file, offset_ + 1);
    note_damage(offset_, found);
    offset_ = found;
    if (found == file.size()) return std::nullopt;
    end = trusted_end(file, found);
  }
  const LogEvent event = event_at(offset_, end);
  offset_ = end;
  last_good_ = event.number;
  return event;
}

LogEvent LogReader::event_at(std::uint64_t begin, std::uint64_t end) const {
  const auto bytes = file_.bytes().subspan(begin, end - begin);
  const std::size_t channel_bytes = get<std::uint32_t>(&bytes[kChannelLengthAt]);
  LogEvent event;
  event.number = static_cast<std::int64_t>(get<std::uint64_t>(&bytes[kNumberAt]));
  event.utime = static_cast<Utime>(get<std::uint64_t>(&bytes[kUtimeAt]));
  event.channel = {reinterpret_cast<const char*>(&bytes[kHeaderBytes]), channel_bytes};
  event.bytes = bytes.subspan(kHeaderBytes + channel_bytes);
  event.offset = begin;
  return event;
}

void LogReader::note_damage(std::uint64_t begin, std::uint64_t end) {
  const auto file = file_.bytes();
  LogDamage damage;
  damage.offset = begin;
  damage.length = end - begin;
  damage.after_event = last_good_;
  const Reason reason = reason_for(file, begin);
  damage.reason = reason.text;
  damage.cut = reason.cut && end == file.size();
  cut_ = cut_ || damage.cut;
  ++damage_count_;
  skipped_bytes_ += damage.length;
  if (damages_.size() < kDamagesKept) damages_.push_back(std::move(damage));
}

std::string LogReader::trouble() const {
  if (damages_.empty()) return {};
  const LogDamage& first = damages_.front();
  std::string text = first.cut ? "cut off" : "damaged";
  text += " at byte " + std::to_string(first.offset);
  text += first.after_event < 0 ? ", before any good event" : ", after event " + std::to_string(first.after_event);
  text += " (" + first.reason + ")";
  if (damage_count_ > 1) text += ", and at " + std::to_string(damage_count_ - 1) + " more places";
  if (cut_ && !first.cut) text += ", and cut off at the end";
  return text + "; " + std::to_string(skipped_bytes_) + " bytes skipped";
}

}  // namespace scanway
