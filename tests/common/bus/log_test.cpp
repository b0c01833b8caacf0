#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <lcm/lcm-cpp.hpp>

#include "common/bus/log_bus.h"
#include "common/bus/log_reader.h"
#include "common/bus/log_writer.h"
#include "common/bus/memory_bus.h"
#include "common/files/input_error.h"
#include "common/random/random.h"
#include "tests/support/command.h"

namespace scanway {
namespace {

using test::ScratchFolder;

struct Event {
  std::int64_t number;
  Utime utime;
  std::string channel;
  std::string data;
  bool operator==(const Event&) const = default;
};

Event copy_of(const LogEvent& event) {
  return {event.number, event.utime, std::string(event.channel), {event.bytes.begin(), event.bytes.end()}};
}

std::vector<Event> read_all(LogReader& log) {
  std::vector<Event> events;
  while (const auto event = log.next()) events.push_back(copy_of(*event));
  return events;
}

std::vector<Event> read_by_lcm(const std::string& path) {
  lcm::LogFile log(path, "r");
  EXPECT_TRUE(log.good());
  std::vector<Event> events;
  while (const lcm::LogEvent* event = log.readNextEvent()) {
    events.push_back({event->eventnum,
                      event->timestamp,
                      event->channel,
                      {static_cast<const char*>(event->data), static_cast<std::size_t>(event->datalen)}});
  }
  return events;
}

std::vector<Event> random_events(Random& random, std::size_t n, std::uint64_t max_bytes) {
  std::vector<Event> events;
  for (std::size_t i = 0; i < n; ++i) {
    Event event{static_cast<std::int64_t>(i), static_cast<Utime>(random.next() >> 2), "", ""};
    for (std::uint64_t c = 1 + random.below(63); c > 0; --c) {
      event.channel += static_cast<char>('A' + static_cast<char>(random.below(26)));
    }
    for (std::uint64_t c = random.below(max_bytes + 1); c > 0; --c) event.data += static_cast<char>(random.next());
    events.push_back(event);
  }
  return events;
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void write_all(const std::string& path, const std::vector<Event>& events) {
  LogWriter log(path);
  for (const Event& event : events) log.write(event.channel, bytes_of(event.data), event.utime);
  log.close();
}

TEST(Log, AgreesWithLcmOnWhatWeWrite) {
  const ScratchFolder scratch;
  Random random(1);
  const auto events = random_events(random, 500, 3000);
  write_all(scratch / "ours.lcmlog", events);
  EXPECT_EQ(read_by_lcm(scratch / "ours.lcmlog"), events);
  LogReader log(scratch / "ours.lcmlog");
  EXPECT_EQ(read_all(log), events);
  EXPECT_EQ(log.trouble(), "");
}

TEST(Log, AgreesWithLcmOnWhatLcmWrites) {
  const ScratchFolder scratch;
  Random random(2);
  const auto events = random_events(random, 500, 3000);
  {
    lcm::LogFile log(scratch / "lcm.lcmlog", "w");
    for (const Event& event : events) {
      lcm::LogEvent out;
      out.eventnum = event.number;
      out.timestamp = event.utime;
      out.channel = event.channel;
      out.datalen = static_cast<std::int32_t>(event.data.size());
      out.data = const_cast<char*>(event.data.data());
      ASSERT_EQ(log.writeEvent(&out), 0);
    }
  }
  write_all(scratch / "ours.lcmlog", events);
  EXPECT_EQ(test::read_text(scratch / "ours.lcmlog"), test::read_text(scratch / "lcm.lcmlog"));
  LogReader log(scratch / "lcm.lcmlog");
  EXPECT_EQ(read_all(log), events);
}

TEST(Log, AgreesWithLcmOnRecordedLogs) {
  const std::string folder = SCANWAY_SHARED_DIR "/data/lcm_logs/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  for (const auto& [name, count] : {std::pair("maebot_convex.lcmlog", 5714U), std::pair("lcm_example.lcmlog", 10U)}) {
    LogReader log(folder + name);
    const auto events = read_all(log);
    EXPECT_EQ(events.size(), count);
    EXPECT_EQ(events, read_by_lcm(folder + name));
    EXPECT_EQ(log.trouble(), "");
  }
}

TEST(Log, ThatIsCutGivesWhatIsWholeAndSaysWhereItIsCut) {
  const ScratchFolder scratch;
  Random random(3);
  const auto events = random_events(random, 6, 40);
  write_all(scratch / "whole", events);
  const std::string whole = test::read_text(scratch / "whole");
  std::vector<std::size_t> ends = {0};
  for (const Event& event : events) ends.push_back(ends.back() + 28 + event.channel.size() + event.data.size());
  for (std::size_t size = 1; size < whole.size(); ++size) {
    test::write_text(scratch / "cut", whole.substr(0, size));
    LogReader log(scratch / "cut");
    const auto good = read_all(log);
    std::size_t expected = 0;
    while (ends[expected + 1] <= size) ++expected;
    ASSERT_EQ(good, std::vector<Event>(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(expected))) << size;
    const bool at_end = ends[expected] == size;  // Between two events: nothing tells that more should follow.
    ASSERT_EQ(log.cut(), !at_end) << size;
    ASSERT_EQ(log.skipped_bytes(), size - ends[expected]);
    if (!at_end) {
      ASSERT_EQ(log.damages().at(0).offset, ends[expected]);
      ASSERT_EQ(log.damages().at(0).after_event, static_cast<std::int64_t>(expected) - 1);
      ASSERT_NE(log.trouble(), "");
    }
  }
}

TEST(Log, WithOneChangedByteLosesAtMostTwoEventsAndHidesNone) {
  const ScratchFolder scratch;
  Random random(4);
  const auto events = random_events(random, 12, 60);
  write_all(scratch / "whole", events);
  const std::string whole = test::read_text(scratch / "whole");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1 + random.below(255)));
    test::write_text(scratch / "changed", bytes);
    LogReader log(scratch / "changed");
    const auto good = read_all(log);
    // Each event is whole, or it is missing and the reader says so; within an event only its own bytes may differ.
    ASSERT_GE(good.size() + 2, events.size()) << at;
    ASSERT_EQ(good.size() < events.size(), log.damage_count() > 0) << at;
    std::size_t different = 0;
    for (const Event& event : good) {
      different += std::find(events.begin(), events.end(), event) == events.end() ? 1 : 0;
    }
    ASSERT_LE(different, 1U) << at;
    std::uint64_t bytes_in_events = 0;
    for (const Event& event : good) bytes_in_events += 28 + event.channel.size() + event.data.size();
    ASSERT_EQ(bytes_in_events + log.skipped_bytes(), bytes.size()) << at;
  }
}

TEST(Log, SurvivesAnyBytes) {
  const ScratchFolder scratch;
  Random random(5);
  write_all(scratch / "log", random_events(random, 8, 60));
  for (int round = 0; round < 1000; ++round) {
    std::string bytes = test::read_text(scratch / "log");
    for (std::uint64_t i = 1 + random.below(10); i > 0; --i) {
      const std::size_t at = random.below(bytes.size());
      const std::size_t n = random.below(30);
      switch (random.below(4)) {
        case 0:
          bytes.erase(at, n);
          break;
        case 1:
          bytes.insert(at, std::string(n, static_cast<char>(random.next())));
          break;
        case 2:
          bytes.insert(at, "\xED\xA1\xDA\x01");
          break;
        default:
          bytes[at] = static_cast<char>(random.next());
      }
      if (bytes.empty()) bytes = "\xED";
    }
    test::write_text(scratch / "bytes", bytes);
    try {
      LogReader log(scratch / "bytes");
      std::uint64_t seen = 0;
      while (const auto event = log.next()) seen += 28 + event->channel.size() + event->bytes.size();
      ASSERT_EQ(seen + log.skipped_bytes(), bytes.size());
    } catch (const InputError&) {
    }
  }
}

TEST(Log, FindsItsWayAfterADamagedStretch) {
  const ScratchFolder scratch;
  Random random(6);
  const auto events = random_events(random, 10, 50);
  write_all(scratch / "whole", events);
  std::string bytes = test::read_text(scratch / "whole");
  std::size_t third = 0;
  for (int i = 0; i < 3; ++i) third += 28 + events[i].channel.size() + events[i].data.size();
  bytes.insert(third, std::string(1000, 'x'));
  test::write_text(scratch / "damaged", bytes);
  LogReader log(scratch / "damaged");
  const auto good = read_all(log);
  // The event before the stretch is not vouched for by a next one, so it is given up with it.
  EXPECT_EQ(good.size(), events.size() - 1);
  EXPECT_EQ(log.damage_count(), 1U);
  EXPECT_FALSE(log.cut());
  EXPECT_EQ(log.damages()[0].after_event, 1);
  EXPECT_EQ(log.skipped_bytes(), 1000 + 28 + events[2].channel.size() + events[2].data.size());
}

TEST(Log, RefusesWhatIsNoLogInOneLine) {
  const ScratchFolder scratch;
  Random random(7);
  test::write_text(scratch / "empty", "");
  test::write_text(scratch / "text", "# .PCD v0.7\nVERSION 0.7\n");
  test::write_text(scratch / "zeros", std::string(5000, '\0'));
  for (const std::string name : {"empty", "text", "zeros", "absent", "", "a\nb"}) {
    try {
      LogReader log(scratch / name);
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

TEST(LogWriter, LeavesNothingWithoutClose) {
  const ScratchFolder scratch;
  { LogWriter(scratch / "log").write("A", {}, 1); }
  EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
  test::write_text(scratch / "log", "old");
  { LogWriter(scratch / "log").write("A", {}, 1); }
  EXPECT_EQ(test::read_text(scratch / "log"), "old");
  EXPECT_THROW(LogWriter(scratch / "absent/log"), InputError);
  LogWriter log(scratch / "log");
  EXPECT_THROW(log.write("", {}, 1), std::invalid_argument);
  EXPECT_THROW(log.write(std::string(64, 'A'), {}, 1), std::invalid_argument);
}

TEST(LogBus, FeedsALogThroughABusIntoAnEqualLog) {
  const ScratchFolder scratch;
  Random random(8);
  const auto events = random_events(random, 50, 100);
  write_all(scratch / "in", events);
  LogReader in(scratch / "in");
  LogWriter out(scratch / "out");
  MemoryBus memory;
  RecordingBus bus(memory, out);
  std::size_t heard = 0;
  bus.subscribe(events[3].channel, [&](const BusMessage&) { ++heard; });
  EXPECT_EQ(feed(in, bus, [&] { memory.dispatch(); }), events.size());
  out.close();
  EXPECT_EQ(heard, 1U);
  EXPECT_EQ(test::read_text(scratch / "in"), test::read_text(scratch / "out"));
}

}  // namespace
}  // namespace scanway
