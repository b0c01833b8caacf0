// The bridge of the scanner as it runs, but for LCM: a device on a TCP socket, the node, a bus in memory.
#include "modules/sick_bridge/node/sick_node.h"

#include <chrono>
#include <functional>
#include <numeric>
#include <thread>

#include "bot_core/raw_t.hpp"
#include "common/bus/channels.h"
#include "common/bus/memory_bus.h"
#include "common/clock/host_time.h"
#include "scanway/line_request_t.hpp"
#include "tests/modules/sick_bridge/loopback_server.h"
#include "tests/modules/sick_bridge/scripted_lms.h"
#include "tests/modules/sick_bridge/whole_line.h"
#include "tests/modules/sick_bridge/yes_man.h"

namespace scanway::test {
namespace {

constexpr Utime kSince = 1'700'000'000 * kMicrosecondsPerSecond;

using Messages = std::vector<std::vector<std::uint8_t>>;

/// The bridge, and what it said so far.
class Bridge {
 public:
  explicit Bridge(LoopbackServer& server, const sick::SickOptions& options = {}, const sick::LmsConfig& config = {})
      : server_(server), device_(server.address(), config), node_(bus_, device_, kSince, options) {
    for (const Channel& channel : {channel::kLaserLine, channel::kLaserScan, channel::kLaserRaw}) {
      bus_.subscribe(channel.name, [this](const BusMessage& message) {
        published[std::string(message.channel)].emplace_back(message.bytes.begin(), message.bytes.end());
      });
    }
  }

  /// Runs device and bridge until `done`; false: not within ten seconds.
  bool run_until(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!done() && std::chrono::steady_clock::now() < end) {
      server_.run();
      turn();
    }
    return done();
  }
  /// One turn of the bridge alone.
  void turn() {
    for (std::string& note : node_.run(1)) notes.push_back(std::move(note));
    if (std::string note = node_.take_welcome(); !note.empty()) notes.push_back(std::move(note));
    bus_.dispatch();
  }
  bool run_until_lines(std::int64_t more) {
    const std::int64_t wanted = counter("sick_lines") + more;
    return run_until([&] { return counter("sick_lines") >= wanted; });
  }

  void ask(Utime numbered_since, std::int64_t first, std::int64_t end) {
    line_request_t request{};
    request.numbered_since = numbered_since;
    request.nranges = 1;
    request.first_line = {first};
    request.end_line = {end};
    bus_.publish(channel::kLineRequest.name, encode(request), 0);
    bus_.dispatch();
  }

  std::int64_t counter(const std::string& name) const { return node_.counters().at(name); }
  std::string summary() const { return node_.summary(); }
  bool noted(const std::string& text) const {
    return std::any_of(notes.begin(), notes.end(), [&](const auto& note) { return note.find(text) != note.npos; });
  }
  MemoryBus& bus() { return bus_; }

  std::map<std::string, Messages> published;
  std::vector<std::string> notes;

 private:
  LoopbackServer& server_;
  MemoryBus bus_;
  sick::LmsDevice device_;
  sick::SickNode node_;
};

/// The LMS511 of the recorded dialogue, which sends the ten recorded scans.
class RecordedDevice : public testing::Test {
 protected:
  static std::string stream() {
    const auto bytes = lms_bytes("lms511_colab_25hz_0.1667_stream10.bin");
    return {bytes.begin(), bytes.end()};
  }
  void SetUp() override { SKIP_WITHOUT_LMS_DATA(); }

  ScriptedLms script_{std::filesystem::exists(kLmsData) ? stream() : std::string()};
  LoopbackServer server_{[this](const std::string& bytes) { return script_.answer(bytes); }};
};

TEST_F(RecordedDevice, ItsLinesAreWhatTheSideFileSays) {
  Bridge bridge(server_);
  ASSERT_TRUE(bridge.run_until_lines(10));
  const auto said = lms_json("lms511_colab_25hz_0.1667_stream10.bin.json")["per_telegram"];
  WholeLines lines;
  for (const auto& message : bridge.published["LASER_LINE"]) lines.add(message);
  ASSERT_EQ(lines.lines().size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    const WholeEcho& line = lines.at(static_cast<std::int64_t>(i));
    ASSERT_TRUE(line.whole());
    ASSERT_EQ(line.ranges.size(), 1141U);
    EXPECT_EQ(line.head.device_time_us, said[i]["time_since_startup_us"]);
    EXPECT_EQ(line.head.numbered_since, kSince);
    EXPECT_EQ(std::vector<int>(line.ranges.begin(), line.ranges.begin() + 4), said[i]["dist1_raw_first4"]);
    EXPECT_EQ(std::vector<int>(line.ranges.end() - 4, line.ranges.end()), said[i]["dist1_raw_last4"]);
    EXPECT_EQ(std::vector<int>(line.rssi.begin(), line.rssi.begin() + 4), said[i]["rssi1_first4"]);
    // Whole lines, not only their ends: against the decoder that the recorded scans are held to.
    const auto scan = parse_scan(telegrams_in(lms_bytes("lms511_colab_25hz_0.1667_stream10.bin"))[i]);
    EXPECT_TRUE(std::equal(line.ranges.begin(), line.ranges.end(), scan.channel("DIST1")->counts.begin()));
    EXPECT_TRUE(std::equal(line.rssi.begin(), line.rssi.end(), scan.channel("RSSI1")->counts.begin()));
  }
  EXPECT_EQ(bridge.published["LASER_SCAN"].size(), 10U);
  EXPECT_TRUE(bridge.published["LASER_RAW"].empty());
  EXPECT_EQ(bridge.counter("sick_missed_scans"), 0);
  EXPECT_EQ(bridge.counter("sick_bad_bytes"), 0);
  EXPECT_EQ(bridge.counter("sick_connections"), 1);
  EXPECT_TRUE(bridge.noted("sends scans (cola_b)"));
}

TEST_F(RecordedDevice, RawTelegramsAreTheDevicesBytesAndLaserScanCanBeOff) {
  Bridge bridge(server_, {.laser_scan = false, .raw = true, .archive = {}});
  ASSERT_TRUE(bridge.run_until_lines(10));
  EXPECT_TRUE(bridge.published["LASER_SCAN"].empty());
  std::string scans;
  for (const auto& message : bridge.published["LASER_RAW"]) {
    const auto raw = decode<bot_core::raw_t>(message);
    const std::string bytes(raw.data.begin(), raw.data.end());
    if (bytes.find("LMDscandata \0", 0) != bytes.npos && bytes.find("sSN") != bytes.npos) scans += bytes;
  }
  EXPECT_EQ(scans, stream());
}

TEST_F(RecordedDevice, LostPiecesAreSentAgainByteForByte) {
  Bridge bridge(server_);
  ASSERT_TRUE(bridge.run_until_lines(10));
  const Messages first = std::exchange(bridge.published["LASER_LINE"], {});
  ASSERT_EQ(first.size(), 40U);
  bridge.ask(kSince, 3, 5);
  ASSERT_TRUE(bridge.run_until([&] { return bridge.published["LASER_LINE"].size() >= 8; }));
  EXPECT_EQ(bridge.published["LASER_LINE"], Messages(first.begin() + 12, first.begin() + 20));
  EXPECT_EQ(bridge.counter("sick_requests"), 1);
  EXPECT_EQ(bridge.counter("sick_lines_resent"), 2);
  bridge.ask(kSince + 1, 3, 5);  // Of a bridge that ran before this one.
  bridge.ask(kSince, 100, 102);
  EXPECT_EQ(bridge.counter("sick_requests_of_other_numberings"), 1);
  EXPECT_EQ(bridge.counter("sick_lines_unknown"), 2);
  EXPECT_EQ(bridge.counter("sick_lines_resent"), 2);
}

TEST_F(RecordedDevice, OlderLinesAreRefusedAndCounted) {
  sick::SickOptions options;
  options.archive.age = 50'000;
  Bridge bridge(server_, options);
  ASSERT_TRUE(bridge.run_until_lines(10));
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  const std::size_t before = bridge.published["LASER_LINE"].size();
  bridge.ask(kSince, 0, 10);
  bridge.turn();
  EXPECT_EQ(bridge.published["LASER_LINE"].size(), before);
  EXPECT_EQ(bridge.counter("sick_lines_too_old"), 10);
}

TEST_F(RecordedDevice, HostileRequestsAreCounted) {
  Bridge bridge(server_);
  ASSERT_TRUE(bridge.run_until_lines(1));
  bridge.bus().publish(channel::kLineRequest.name, Messages{{1, 2, 3}}[0], 0);
  bridge.bus().dispatch();
  EXPECT_EQ(bridge.counter("sick_bad_requests"), 1);
  line_request_t request{};
  request.numbered_since = kSince;
  request.first_line.assign(100, 0);
  request.end_line.assign(100, 1);
  request.nranges = 100;
  bridge.bus().publish(channel::kLineRequest.name, encode(request), 0);
  bridge.bus().dispatch();
  EXPECT_EQ(bridge.counter("sick_bad_requests"), 2);
  EXPECT_EQ(bridge.counter("sick_requests"), 0);
}

TEST_F(RecordedDevice, UnpluggedAndBackItGoesOnNumbering) {
  Bridge bridge(server_);
  ASSERT_TRUE(bridge.run_until_lines(10));
  server_.unplug();
  ASSERT_TRUE(bridge.run_until([&] { return bridge.summary().find("Connection refused") != std::string::npos; }))
      << bridge.summary();
  server_.plug_in();
  ASSERT_TRUE(bridge.run_until_lines(10));
  EXPECT_EQ(bridge.summary().find("refused;"), std::string::npos);
  EXPECT_EQ(bridge.counter("sick_connections"), 2);
  WholeLines lines;
  for (const auto& message : bridge.published["LASER_LINE"]) lines.add(message);
  EXPECT_EQ(lines.lines().size(), 20U);
  for (const auto& [key, line] : lines.lines()) EXPECT_TRUE(line.whole());
}

TEST_F(RecordedDevice, AbsentAtTheStartItIsFoundWhenItComes) {
  server_.unplug();
  Bridge bridge(server_);
  ASSERT_TRUE(bridge.run_until([&] { return !bridge.summary().empty() && !bridge.notes.empty(); }));
  EXPECT_EQ(bridge.notes.size(), 1U);
  EXPECT_EQ(bridge.counter("sick_connections"), 0);
  server_.plug_in();
  EXPECT_TRUE(bridge.run_until_lines(10));
}

TEST_F(RecordedDevice, SlowToStartItIsWaitedFor) {
  // It takes the connection and says nothing for 2.5 s, as while it boots.
  const auto begin = std::chrono::steady_clock::now();
  LoopbackServer slow([&](const std::string& bytes) {
    if (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(2500)) return std::string();
    return script_.answer(bytes);
  });
  Bridge bridge(slow);
  EXPECT_TRUE(bridge.run_until_lines(10));
  EXPECT_EQ(bridge.counter("sick_connections"), 1);
}

TEST_F(RecordedDevice, RebootedItIsSetUpAgain) {
  Bridge bridge(server_);
  ASSERT_TRUE(bridge.run_until_lines(10));
  server_.hang_up();
  ASSERT_TRUE(bridge.run_until_lines(10));
  EXPECT_EQ(bridge.counter("sick_connections"), 2);
  EXPECT_TRUE(bridge.noted("the device closed the connection"));
}

TEST_F(RecordedDevice, DamageAndGapsAreCounted) {
  Bridge bridge(server_);
  ASSERT_TRUE(bridge.run_until_lines(10));
  const Bytes scan = lms_bytes("lms511_colab_25hz_0.1667_scan_a.bin");
  Bytes broken = scan;
  broken[1000] ^= 1;
  server_.send({broken.begin(), broken.end()});
  server_.send({scan.begin(), scan.end()});
  ASSERT_TRUE(bridge.run_until_lines(1));
  EXPECT_EQ(bridge.counter("sick_lines"), 11);
  EXPECT_EQ(bridge.counter("sick_bad_bytes"), static_cast<std::int64_t>(broken.size()));
}

/// Scans of a few beams from a device that is told what to say.
TEST(SickNode, CountsWhatIsMissingByBothCounters) {
  YesMan device(sick::Dialect::cola_b);
  LoopbackServer server([&](const std::string& bytes) { return device.answer(bytes); });
  Bridge bridge(server);
  ASSERT_TRUE(
      bridge.run_until([&] { return std::count(device.asked.begin(), device.asked.end(), "sEN LMDscandata"); }));
  for (const int counter : {65534, 65535, 0, 3, 4}) {
    const Bytes scan = small_scan(static_cast<std::uint16_t>(counter));
    server.send({scan.begin(), scan.end()});
  }
  ASSERT_TRUE(bridge.run_until_lines(5));
  EXPECT_EQ(bridge.counter("sick_missed_scans"), 2);
  EXPECT_EQ(bridge.counter("sick_missed_telegrams"), 2);
  // The device says that there is a little dirt on its window.
  EXPECT_EQ(bridge.counter("sick_contamination"), 1);
  EXPECT_EQ(bridge.summary(), "dirt on the scanner's window: warning");
}

/// A scan whose clock said so many microseconds; it is sent 41 ms later.
std::string scan_at(std::uint32_t start_us, std::uint16_t counter) {
  const Bytes frame = small_scan(counter);
  std::string body(frame.begin() + 8, frame.end() - 1), times;
  append_big_endian(times, start_us, 4);
  append_big_endian(times, static_cast<std::uint32_t>(start_us + 41'000), 4);
  return sick::make_frame(sick::Dialect::cola_b, body.replace(30, 8, times));
}

TEST(SickNode, TheDevicesClockGoesOnOverItsWrapAfter71Minutes) {
  YesMan device(sick::Dialect::cola_b);
  LoopbackServer server([&](const std::string& bytes) { return device.answer(bytes); });
  Bridge bridge(server);
  ASSERT_TRUE(
      bridge.run_until([&] { return std::count(device.asked.begin(), device.asked.end(), "sEN LMDscandata"); }));
  const std::uint32_t before_wrap = 0xFFFFFFFF - 100'000;
  for (std::uint16_t i = 0; i < 5; ++i) {
    server.send(scan_at(before_wrap + 40'000U * i, i));
    ASSERT_TRUE(bridge.run_until_lines(1));
  }
  ASSERT_EQ(bridge.published["LASER_LINE"].size(), 5U);
  std::vector<laser_line_t> lines;
  for (const auto& message : bridge.published["LASER_LINE"]) lines.push_back(decode<laser_line_t>(message));
  // They are sent faster than they were measured; a clock that lost count would be off by 4,294 s.
  for (const laser_line_t& line : lines) {
    EXPECT_NEAR(static_cast<double>(line.utime - host_now()), 0, 2e6);
    EXPECT_LE(line.utime, host_now() - 41'000);
  }
  EXPECT_LT(lines[4].device_time_us, lines[0].device_time_us);
  EXPECT_EQ(bridge.counter("sick_clock_jumps"), 0);
}

TEST(SickNode, AnotherModelIsOneClearLine) {
  YesMan device(sick::Dialect::cola_b);
  device.model = "LMS111-10100";
  LoopbackServer server([&](const std::string& bytes) { return device.answer(bytes); });
  Bridge bridge(server);
  ASSERT_TRUE(bridge.run_until([&] { return bridge.noted("'LMS111-10100', no LMS5xx"); }));
}

TEST(SickNode, AnotherServiceIsOneClearLine) {
  LoopbackServer server([](const std::string&) { return "HTTP/1.1 400 Bad Request\r\n\r\n"; });
  Bridge bridge(server);
  ASSERT_TRUE(bridge.run_until([&] { return !bridge.notes.empty(); }));
  EXPECT_TRUE(bridge.noted("neither CoLa-A nor CoLa-B: is this the port of an LMS5xx (2111 or 2112)?"));
  EXPECT_EQ(bridge.summary(), bridge.notes[0]);
}

TEST(SickNode, InterlacedScansInTextPass) {
  SKIP_WITHOUT_LMS_DATA();
  YesMan device(sick::Dialect::cola_a);
  LoopbackServer server([&](const std::string& bytes) { return device.answer(bytes); });
  sick::LmsConfig config;
  config.first_dialect = sick::Dialect::cola_a;
  Bridge bridge(server, {}, config);
  ASSERT_TRUE(
      bridge.run_until([&] { return std::count(device.asked.begin(), device.asked.end(), "sEN LMDscandata"); }));
  const auto stream = lms_bytes("lms5xx_colaa_100hz_interlaced_stream5.bin");
  server.send({stream.begin(), stream.end()});
  ASSERT_TRUE(bridge.run_until_lines(5));
  const auto said = lms_json("lms5xx_colaa_100hz_interlaced_stream5.bin.json")["per_telegram"];
  ASSERT_EQ(bridge.published["LASER_LINE"].size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto line = decode<laser_line_t>(bridge.published["LASER_LINE"][i]);
    const auto& channel = said[i]["channels_16bit"][0];
    EXPECT_EQ(line.nbeams, channel["count"]);
    EXPECT_EQ(std::accumulate(line.range_count.begin(), line.range_count.end(), 0L), channel["raw_sum"]);
    EXPECT_EQ(line.nrssi, 0);
  }
}

}  // namespace
}  // namespace scanway::test
