#include "modules/simulator/device/lms/lms_emulator.h"

#include <array>
#include <map>
#include <sstream>

#include "modules/sick_bridge/device/lms_device.h"
#include "modules/simulator/device/ends/tcp_end.h"
#include "tests/modules/simulator/device/shared_facts.h"

namespace scanway::test {
namespace {

using namespace simulator;

ScanTelegram::Channel channel_of(const nlohmann::json& input) {
  ScanTelegram::Channel channel;
  channel.content = input[0];
  channel.start_angle = input[1];
  channel.angular_step = input[2];
  for (const int count : input[3]) channel.counts.push_back(static_cast<std::uint16_t>(count));
  if (input.size() > 4) channel.scale = input[4];
  return channel;
}

/// The derived scans share one head.
ScanTelegram derived_scan(const nlohmann::json& input) {
  ScanTelegram scan;
  scan.telegram_counter = 10;
  scan.scan_counter = 12;
  scan.start_us = 1'000'000;
  scan.sent_us = 1'041'000;
  scan.outputs = 0x3F;
  for (const auto& encoder : input.at("enc")) scan.encoders.push_back({encoder[0], encoder[1]});
  for (const auto& channel : input.at("c16")) scan.ranges.push_back(channel_of(channel));
  for (const auto& channel : input.at("c8")) scan.remissions.push_back(channel_of(channel));
  if (const auto& t = input.at("time"); !t.is_null()) scan.date = {t[0], t[1], t[2], t[3], t[4], t[5], t[6]};
  if (const auto& e = input.at("event"); !e.is_null()) scan.event = {e[0], e[1], e[2]};
  return scan;
}

TEST(ScanTelegram, TheDerivedScansByteForByte) {
  SKIP_WITHOUT_FACTS();
  int tried = 0;
  const auto vectors = facts_json("sick/data/derived_scans.json");
  for (const auto& [file, vector] : vectors.items()) {
    const Cola cola = vector.at("encoding") == "colab" ? Cola::b : Cola::a;
    EXPECT_EQ(hex_of(encode(derived_scan(vector.at("input")), cola)), hex_of(facts_text("sick/data/" + file))) << file;
    ++tried;
  }
  EXPECT_EQ(tried, 6);
}

/// Numbers at offsets of a recorded scan of 1141 beams with RSSI and date, by the sheet's table.
struct RecordedScan {
  std::string bytes;
  std::uint32_t at(std::size_t offset, int size) const {
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(offset + std::size_t(i)));
    return value;
  }
  ScanTelegram read() const {
    ScanTelegram scan;
    scan.serial_number = at(28, 4);
    scan.status = at(32, 1) | at(33, 1) << 8;
    scan.telegram_counter = static_cast<std::uint16_t>(at(34, 2));
    scan.scan_counter = static_cast<std::uint16_t>(at(36, 2));
    scan.start_us = at(38, 4);
    scan.sent_us = at(42, 4);
    scan.inputs = at(46, 1);
    scan.outputs = at(48, 1);
    const std::size_t ranges = 64, remissions = ranges + 21 + 2 * 1141 + 2, date = remissions + 21 + 1141 + 8;
    scan.ranges = {{"DIST1", 1.0F, -50000, 1667, {}}};
    scan.remissions = {{"RSSI1", 1.0F, -50000, 1667, {}}};
    for (std::size_t i = 0; i < 1141; ++i) {
      scan.ranges[0].counts.push_back(static_cast<std::uint16_t>(at(ranges + 21 + 2 * i, 2)));
      scan.remissions[0].counts.push_back(static_cast<std::uint16_t>(at(remissions + 21 + i, 1)));
    }
    scan.date = {at(date, 2),     at(date + 2, 1), at(date + 3, 1), at(date + 4, 1),
                 at(date + 5, 1), at(date + 6, 1), at(date + 7, 4)};
    return scan;
  }
};

TEST(ScanTelegram, RecordedScansByteForByteInBothDialects) {
  SKIP_WITHOUT_FACTS();
  for (const std::string name : {"scan_a", "scan_b", "status_not_ok"}) {
    const std::string bytes = facts_text("sick/data/lms511_colab_25hz_0.1667_" + name + ".bin");
    const ScanTelegram scan = RecordedScan{bytes}.read();
    EXPECT_EQ(hex_of(encode(scan, Cola::b)), hex_of(bytes)) << name;
    if (name != "scan_a") continue;
    EXPECT_EQ(encode(scan, Cola::a), facts_text("sick/data/lms511_colaa_25hz_0.1667_scan_a_transcoded.bin"));
  }
}

ScannedLine plain_line(const MirrorTurn& turn) {
  const auto beams = static_cast<std::size_t>(turn.sector.beams);
  ScannedLine line;
  for (std::size_t i = 0; i < beams; ++i) {
    line.ranges.push_back(static_cast<std::uint16_t>(1000 + 3 * i + static_cast<std::size_t>(turn.number % 100)));
    line.remissions.push_back(static_cast<std::uint8_t>(i));
  }
  return line;
}

struct Exchange {
  std::string dir, bytes;
};

std::vector<Exchange> recorded_dialogue(const std::string& name) {
  std::istringstream lines(facts_text("sick/data/" + name));
  std::vector<Exchange> all;
  for (std::string line; std::getline(lines, line);) {
    const auto entry = nlohmann::json::parse(line);
    all.push_back({entry.at("dir"), unhex(entry.at("hex"))});
  }
  return all;
}

std::string name_in(const std::string& frame) { return frame.substr(12, frame.find(' ', 12) - 12); }

/// With its times and checksum zeroed: the counter and the date of an input state.
std::string without_times(std::string frame) {
  if (frame.find("LIDinputstate ") == frame.npos || frame.size() < 50) return frame;
  for (const auto& [from, size] : {std::pair{28, 4}, {38, 11}, {49, 1}}) {
    frame.replace(static_cast<std::size_t>(from), static_cast<std::size_t>(size), static_cast<std::size_t>(size), '\0');
  }
  return frame;
}

TEST(LmsEmulator, AnswersTheRecordedDialogueWithTheRecordedBytes) {
  SKIP_WITHOUT_FACTS();
  int compared = 0;
  for (const std::string file : {"lms511_colab_session_20210302.jsonl", "lms511_colab_session_20210301_sfa.jsonl"}) {
    LmsEmulator lms(plain_line);
    const auto dialogue = recorded_dialogue(file);
    // What a user had stored in the device's evaluation fields is data.
    for (const auto& [dir, bytes] : dialogue) {
      if (dir == "sensor->host" && bytes.find("sRA field") != bytes.npos) {
        const std::size_t begin = 8 + 3 + 1 + 8 + 1;
        lms.keep(name_in(bytes), bytes.substr(begin, bytes.size() - begin - 1));
      }
    }
    std::string expected;
    for (const auto& [dir, bytes] : dialogue) {
      if (dir == "host->sensor") {
        expected = lms.receive(bytes, 2'716'717);
      } else if (bytes.find("sSN") == bytes.npos) {
        EXPECT_EQ(hex_of(without_times(expected)), hex_of(without_times(bytes))) << name_in(bytes);
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 56);
}

/// Answers in both dialects, by the table of command vectors: request and the answer it asks for.
TEST(LmsEmulator, AnswersTheCommandVectors) {
  SKIP_WITHOUT_FACTS();
  std::map<std::string, std::string> vectors;  // "CoLa-A login_req".
  std::istringstream lines(facts_text("sick/data/command_vectors.csv"));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream row(line);
    std::string id, encoding, direction, hex;
    std::getline(row, id, ',') && std::getline(row, encoding, ',') && std::getline(row, direction, ',');
    std::getline(row, hex, ',');
    vectors[encoding + ' ' + id] = hex;
  }
  const std::vector<std::pair<std::string, std::string>> wanted = {
      {"login_req", "login_ok"},
      {"setscancfg_25hz_01667_req", "setscancfg_25hz_01667_ok"},
      {"echofilter_1_req", "echofilter_ok"},
      {"range_write_req", "range_write_ok"},
      {"scandatacfg_rssi_time_enc_req", "scandatacfg_ok"},
      {"meewriteall_req", "eewrite_ok"},
      {"lmcstartmeas_req", "startmeas_ok"},
      {"run_req", "run_ok"},
      {"echofilter_0_req", "sfa_1"},  // Run has logged out.
      {"scan_off_req", "scan_off_ok"},
      {"scan_on_req", "scan_on_ok"}};
  int compared = 0;
  for (const std::string dialect : {"CoLa-A", "CoLa-B"}) {
    LmsEmulator lms(plain_line);
    for (const auto& [request, answer] : wanted) {
      const auto asked = vectors.find(dialect + ' ' + request), told = vectors.find(dialect + ' ' + answer);
      if (asked == vectors.end()) continue;
      const std::string heard = lms.receive(unhex(asked->second), 0);
      if (told == vectors.end()) continue;
      EXPECT_EQ(hex_of(heard), hex_of(unhex(told->second))) << dialect << ' ' << request;
      ++compared;
    }
  }
  EXPECT_GE(compared, 15);
}

TEST(LmsEmulator, RefusesWhatItDoesNotKnow) {
  LmsEmulator lms(plain_line);
  const auto ask = [&](const std::string& body) { return lms.receive('\x02' + body + '\x03', 0); };
  EXPECT_EQ(ask("sRN NoSuchThing"), "\x02sFA 3\x03");
  EXPECT_EQ(ask("sMN NoSuchThing"), "\x02sFA 2\x03");
  EXPECT_EQ(ask("sEN NoSuchThing 1"), "\x02sFA F\x03");
  EXPECT_EQ(ask("sXX NoSuchThing"), "\x02sFA C\x03");
  EXPECT_EQ(ask("sMN SetAccessMode 03"), "\x02sFA 8\x03");
  EXPECT_EQ(ask("sMN SetAccessMode 03 F4724745"), "\x02sAN SetAccessMode 0\x03");
  EXPECT_EQ(ask("sMN SetAccessMode 03 F4724744"), "\x02sAN SetAccessMode 1\x03");
  EXPECT_EQ(ask("sMN mLMPsetscancfg +2500 +1 +3333 -50000 +1850000"),
            "\x02sAN mLMPsetscancfg 2 9C4 1 D05 FFFF3CB0 1C3A90\x03");
}

/// Runs the bridge's device against the emulator over a socket until it has so many scans.
std::vector<sick::TimedScan> talk(const sick::LmsConfig& config, std::size_t scans, LmsEmulator& lms) {
  TcpEnd end(0);
  sick::LmsDevice device({"127.0.0.1", end.port()}, config);
  std::vector<sick::TimedScan> all;
  Utime now = 4'294'000'000;  // The clock of 32 bits wraps soon.
  for (int i = 0; i < 20'000 && all.size() < scans; ++i, now += 1000) {
    const auto heard = end.hear();
    if (heard.new_host) lms.hang_up();
    if (const std::string answers = lms.receive(heard.bytes, now); !answers.empty()) end.say(answers);
    for (const std::string& frame : lms.tick(now)) EXPECT_TRUE(end.say(frame));
    for (auto& scan : device.run(1).scans) all.push_back(std::move(scan));
  }
  EXPECT_EQ(device.counters().bad_telegrams + device.counters().bad_bytes + device.counters().unanswered, 0U);
  EXPECT_EQ(device.counters().missed_scans + device.counters().missed_telegrams, 0U);
  return all;
}

TEST(LmsEmulator, TheBridgeHearsWhatTheEmulatorSaw) {
  for (const auto dialect : {sick::Dialect::cola_a, sick::Dialect::cola_b}) {
    sick::LmsConfig config;
    config.first_dialect = dialect;
    std::vector<MirrorTurn> turns;
    LmsEmulator lms([&](const MirrorTurn& turn) {
      turns.push_back(turn);
      return plain_line(turn);
    });
    const auto scans = talk(config, 12, lms);
    ASSERT_EQ(scans.size(), 12U);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      const sick::Scan& scan = scans[i].scan;
      const ScannedLine line = plain_line(turns[i]);
      ASSERT_EQ(scan.channels_16_bit.size(), 1U);
      EXPECT_EQ(scan.channels_16_bit[0].counts, line.ranges);
      EXPECT_EQ(text_of(scan.channels_8_bit[0].counts), text_of(line.remissions));
      EXPECT_EQ(scan.start_time_us, static_cast<std::uint32_t>(turns[i].start));
      const auto on_the_way = scan.transmission_time_us - scan.start_time_us;
      EXPECT_GE(on_the_way, 39'900U);
      EXPECT_LE(on_the_way, 41'100U);
      EXPECT_EQ(turns[i].sector.beams, 1141);
    }
  }
}

TEST(LmsEmulator, AnotherModeAndASector) {
  sick::LmsConfig config;
  config.scan.frequency = 5000;
  config.scan.resolution = 3333;
  config.sector_start = 0;
  config.sector_stop = 1800000;
  LmsEmulator lms(plain_line);
  const auto scans = talk(config, 5, lms);
  ASSERT_EQ(scans.size(), 5U);
  const auto& channel = scans.back().scan.channels_16_bit.at(0);
  EXPECT_EQ(channel.counts.size(), 541U);
  EXPECT_EQ(channel.start_angle, 0);
  EXPECT_EQ(scans.back().scan.scan_frequency, 5000U);
  EXPECT_EQ(scans.back().scan.measurement_frequency, 540U);
}

TEST(LmsEmulator, InterlacedTurnsBeginWhereTheRecordedOnesDo) {
  ScanMode mode;
  mode.frequency = 10000;
  mode.resolution = 1667;
  ASSERT_EQ(scan_mode_error(mode), 0U);
  EXPECT_EQ(mode.measurement_frequency(), 540U);
  const std::array<std::pair<std::int32_t, int>, 4> recorded = {
      {{-50000, 286}, {-46666, 285}, {-48333, 285}, {-44999, 285}}};
  for (std::int64_t turn = 0; turn < 8; ++turn) {
    const ScanSector sector = sector_of(mode, -50000, 1850000, turn);
    EXPECT_EQ(sector.written_start, recorded[static_cast<std::size_t>(turn % 4)].first);
    EXPECT_EQ(sector.beams, recorded[static_cast<std::size_t>(turn % 4)].second);
  }
}

TEST(LmsEmulator, ScansThatItHasNoTimeForAreCounted) {
  LmsEmulator lms(plain_line);
  lms.receive("\x02sEN LMDscandata 1\x03", 0);
  Utime now = 100'000;
  std::size_t sent = lms.tick(now).size();
  EXPECT_EQ(lms.dropped(), 0);
  now += 60 * kMicrosecondsPerSecond;                           // Nobody lets it run.
  const std::int64_t due = lms.mirror().last_sent_before(now);  // Since turn 1, the first after it was asked for them.
  for (std::size_t more = 1; more > 0; sent += more) more = lms.tick(now).size();
  EXPECT_GT(lms.dropped(), 400);
  EXPECT_EQ(lms.dropped() + static_cast<std::int64_t>(sent), due);
}

}  // namespace
}  // namespace scanway::test
