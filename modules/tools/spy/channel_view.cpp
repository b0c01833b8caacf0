#include "modules/tools/spy/channel_view.h"

#include <iostream>

#include <fmt/format.h>

#include "common/files/printable.h"
#include "modules/tools/output/json_line.h"
#include "modules/tools/spy/message_json.h"

namespace scanway::tools {

using Kind = Sighting::Kind;

void ChannelView::take(const Sighting& sighting) {
  if (sighting.channel != options_.channel || done()) return;
  if (sighting.kind == Kind::message || sighting.kind == Kind::object) {
    ++good_;
    take_good(sighting);
  } else if (sighting.kind == Kind::foreign) {
    take_fault(fmt::format("{} bytes of a type that is not in lcmtypes", sighting.bytes.size()));
  } else if (sighting.kind == Kind::bad) {
    take_fault(sighting.reason);
  }
}

void ChannelView::take_good(const Sighting& sighting) {
  if (options_.json) return write_json(sighting);
  text_ = message_text(message_json(*sighting.layout, sighting.bytes, options_.elements));
  if (sighting.kind == Kind::object) {
    text_ =
        fmt::format("  object \"{}\", version {}\n{}", printable(sighting.piece->key), sighting.piece->version, text_);
  }
  if (is_refreshed()) return;
  screen_.show(fmt::format("{}  {}\n{}", printable(sighting.channel), sighting.layout->name, text_));
}

void ChannelView::write_json(const Sighting& sighting) const {
  nlohmann::ordered_json line{{"channel", printable(sighting.channel)}, {"type", sighting.layout->name}};
  if (sighting.kind == Kind::object) {
    line["key"] = sighting.piece->key;
    line["version"] = sighting.piece->version;
  }
  line["message"] = message_json(*sighting.layout, sighting.bytes);
  write_line(std::cout, line);
  std::cout.flush();
}

void ChannelView::take_fault(const std::string& fault) {
  fault_ = printable(fault);
  if (options_.json) {
    write_line(std::cout, {{"channel", printable(options_.channel)}, {"type", "bad"}, {"reason", fault_}});
    std::cout.flush();
  } else if (!is_refreshed()) {
    screen_.show(fmt::format("{}  bad: {}\n", printable(options_.channel), fault_));
  }
}

void ChannelView::refresh(const Traffic& traffic, SteadyTime now) const {
  if (!is_refreshed()) return;
  std::string head = printable(options_.channel) + ": nothing yet\n";
  if (const auto found = traffic.channels().find(options_.channel); found != traffic.channels().end()) {
    const ChannelTraffic& channel = found->second;
    head = fmt::format("{}  {}  {:.1f} Hz, {:.1f} s old, {} {}, {} bad\n", printable(options_.channel), channel.type,
                       channel.arrivals.rate_hz(now), channel.arrivals.age_s(now),
                       channel.cut ? channel.objects : channel.messages, channel.cut ? "objects" : "messages",
                       channel.bad);
  }
  screen_.show(head + text_ + (fault_.empty() ? "" : "last bad: " + fault_ + "\n"));
}

}  // namespace scanway::tools
