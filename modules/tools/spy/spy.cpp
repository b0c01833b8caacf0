#include "modules/tools/spy/spy.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <limits>

#include <spdlog/spdlog.h>

#include "common/bus/lcm_bus.h"
#include "common/bus/lcm_url.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "modules/tools/output/json_line.h"
#include "modules/tools/spy/asker.h"
#include "modules/tools/spy/channel_view.h"
#include "modules/tools/spy/relay.h"
#include "modules/tools/spy/screen.h"
#include "modules/tools/spy/traffic.h"
#include "modules/tools/spy/traffic_text.h"

namespace scanway::tools {
namespace {

constexpr int kNothingCame = 1;
constexpr double kTableSeconds = 2.0;
constexpr SteadyTime kWindow = 5'000'000;
constexpr SteadyTime kRefresh = 500'000;
constexpr SteadyTime kJsonRefresh = 1'000'000;
constexpr auto kWait = std::chrono::milliseconds(20);

SteadyTime microseconds(double seconds) { return static_cast<SteadyTime>(seconds * 1e6); }

/// A bus that is watched: all that comes goes to `traffic`, and to `listener` what it was.
class Watch {
 public:
  Watch(LcmBus& bus, SteadyTime window, const std::vector<std::string>& ask, Traffic::Listener listener = {})
      : bus_(bus), asker_(bus, ask), traffic_(window, [this, listener](const Sighting& sighting) {
          asker_.hear(sighting, steady_now());
          if (listener) listener(sighting);
        }) {
    bus.subscribe_all([this](const BusMessage& message) { traffic_.take(message, steady_now()); });
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Until `seconds` have passed (nothing: for ever) or `done` is true. `show` is called now and then.
  void run(std::optional<double> seconds, SteadyTime refresh, const std::function<void()>& show = {},
           const std::function<bool()>& done = {}) {
    const SteadyTime begun = steady_now();
    const SteadyTime end = seconds ? begun + microseconds(*seconds) : std::numeric_limits<SteadyTime>::max();
    SteadyTime due = begun;
    while (steady_now() < end && !(done && done())) {
      bus_.dispatch(kWait);
      asker_.ask(steady_now());
      if (!show || steady_now() < due) continue;
      show();
      due = steady_now() + refresh;
    }
  }

  const Traffic& traffic() const { return traffic_; }

 private:
  LcmBus& bus_;
  Asker asker_;
  Traffic traffic_;
};

int show_table(LcmBus& bus, const SpyOptions& options) {
  const Screen screen;
  const bool goes_on = !options.once && !options.seconds && (options.json || screen.is_terminal());
  const double seconds = options.seconds.value_or(kTableSeconds);
  Watch watch(bus, goes_on ? kWindow : std::max(kWindow, microseconds(seconds)), options.ask);
  const auto show = [&] {
    if (options.json) {
      write_line(std::cout, traffic_json(watch.traffic(), steady_now()));
      std::cout.flush();
    } else {
      screen.show(traffic_table(watch.traffic(), steady_now()));
    }
  };
  if (goes_on) {
    watch.run(std::nullopt, options.json ? kJsonRefresh : kRefresh, show);
  } else {
    watch.run(seconds, kRefresh);
    show();
  }
  return 0;
}

int show_channel(LcmBus& bus, const SpyOptions& options) {
  std::vector<std::string> ask = options.ask;
  ask.push_back(options.channel);
  ChannelView view({options.channel, options.once, options.json, options.elements});
  Watch watch(bus, kWindow, ask, [&view](const Sighting& sighting) { view.take(sighting); });
  watch.run(
      options.seconds, kRefresh, [&] { view.refresh(watch.traffic(), steady_now()); }, [&] { return view.done(); });
  if (view.good() > 0) return 0;
  spdlog::warn("nothing good came on {}", printable(options.channel));
  return kNothingCame;
}

int pass_on(LcmBus& bus, const SpyOptions& options) {
  if (options.relay == lcm_url(options.lcm_url)) {
    throw InputError("--relay " + printable(options.relay) + ": that is the bus that is watched; name another");
  }
  LcmBus to(options.relay);
  Relay relay(to);
  Watch watch(bus, kWindow, options.ask, [&relay](const Sighting& sighting) { relay.pass(sighting); });
  watch.run(options.seconds, kRefresh);
  return 0;
}

}  // namespace

int run_spy(const SpyOptions& options) {
  LcmBus bus(lcm_url(options.lcm_url));
  if (!bus.advice().empty()) spdlog::warn("{}", bus.advice());
  if (!options.relay.empty()) return pass_on(bus, options);
  return options.channel.empty() ? show_table(bus, options) : show_channel(bus, options);
}

}  // namespace scanway::tools
