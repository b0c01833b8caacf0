#pragma once

#include <cstdint>
#include <string>

#include "modules/tools/spy/screen.h"
#include "modules/tools/spy/traffic.h"

namespace scanway::tools {

/// What is shown of one channel: its messages as they come, or the newest one, refreshed, on a terminal.
class ChannelView {
 public:
  struct Options {
    std::string channel;
    bool once = false;      ///< The first good message is enough.
    bool json = false;      ///< JSON lines.
    unsigned elements = 8;  ///< Of an array, for people.
  };

  explicit ChannelView(Options options) : options_(std::move(options)) {}

  void take(const Sighting& sighting);
  /// Shows the newest message, if that is how things are shown here.
  void refresh(const Traffic& traffic, SteadyTime now) const;

  bool done() const { return options_.once && good_ > 0; }
  std::uint64_t good() const { return good_; }
  bool is_refreshed() const { return !options_.json && !options_.once && screen_.is_terminal(); }

 private:
  void take_good(const Sighting& sighting);
  void write_json(const Sighting& sighting) const;
  void take_fault(const std::string& fault);

  const Options options_;
  Screen screen_;
  std::uint64_t good_ = 0;
  std::string text_;   // The newest good message.
  std::string fault_;  // Why the newest bad one is bad.
};

}  // namespace scanway::tools
