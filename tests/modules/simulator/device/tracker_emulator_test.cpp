#include "modules/simulator/device/tracker/tracker_emulator.h"

#include <bit>
#include <cmath>

#include "common/bytes/big_endian.h"
#include "common/clock/steady_time.h"
#include "modules/simulator/device/ends/terminal_end.h"
#include "modules/simulator/device/tracker/mtdata_output.h"
#include "modules/xsens_bridge/device/tracker_device.h"
#include "tests/modules/simulator/device/shared_facts.h"

namespace scanway::test {
namespace {

using namespace simulator;

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// An item's numbers, by the sheet's rules for the four formats.
std::vector<double> numbers_of(std::uint16_t id, std::span<const std::uint8_t> bytes) {
  std::vector<double> numbers;
  for (BigEndianReader reader(bytes); reader.left() > 0;) {
    if ((id & 3) == 0) {
      numbers.push_back(static_cast<double>(reader.f32()));
    } else if ((id & 3) == 1) {
      numbers.push_back(reader.i32() / 1048576.0);
    } else if ((id & 3) == 2) {
      const double fraction = reader.u32() / 4294967296.0;
      numbers.push_back(fraction + reader.i16());
    } else {
      numbers.push_back(reader.f64());
    }
  }
  return numbers;
}

bool holds_numbers(std::uint16_t id) {
  const unsigned group = id >> 12;
  return group == 0 || group == 2 || group == 4 || group == 8 || group == 0xC || group == 0xD;
}

/// Every recorded measurement, taken apart by the sheet and written again by the emulator's encoder.
TEST(Xbus, TheRecordedMeasurementsByteForByte) {
  SKIP_WITHOUT_FACTS();
  int tried = 0, items = 0;
  for (const auto& vectors = facts_json("xsens/vectors.json"); const auto& vector : vectors.at("vectors")) {
    const std::string message = unhex(vector.at("hex"));
    if (message.size() < 5 || static_cast<std::uint8_t>(message[2]) != 0x36) continue;
    const bool extended = static_cast<std::uint8_t>(message[3]) == 0xFF;
    const std::size_t head = extended ? 6 : 4;
    XbusBytes data;
    for (BigEndianReader reader(bytes_of(message).subspan(head, message.size() - head - 1)); reader.left() > 0;) {
      const std::uint16_t id = reader.u16();
      const auto content = reader.take(reader.u8());
      if (holds_numbers(id)) {
        append_numbers(data, id, numbers_of(id, content));
        ++items;
      } else if (content.size() <= 4 && content.size() != 3) {
        BigEndianReader number(content);
        const std::uint32_t value = content.size() == 1   ? number.u8()
                                    : content.size() == 2 ? number.u16()
                                                          : number.u32();
        append_integer(data, id, value, static_cast<int>(content.size()));
        ++items;
      } else {
        append_big_endian(data, id, 2);
        append_big_endian(data, content.size(), 1);
        data.insert(data.end(), content.begin(), content.end());
      }
    }
    EXPECT_EQ(hex_of(text_of(xbus_message(0x36, data))), hex_of(message)) << vector.at("name");
    ++tried;
  }
  EXPECT_GE(tried, 8);
  EXPECT_GE(items, 30);
}

TrackerSample recorded_sample(std::int64_t, Utime) {
  TrackerSample sample;
  sample.q_world_sensor = Eigen::Quaterniond(
      static_cast<double>(std::bit_cast<float>(0x3F71CE6CU)), static_cast<double>(std::bit_cast<float>(0xBEA56BCFU)),
      static_cast<double>(std::bit_cast<float>(0x3C613BD8U)), static_cast<double>(std::bit_cast<float>(0xBD691D25U)));
  return sample;
}

TEST(TrackerEmulator, AnswersTheRecordedSetUp) {
  SKIP_WITHOUT_FACTS();
  const auto vectors = facts_json("xsens/vectors.json");
  const auto named = [&](const char* name) { return vector_named(vectors, name); };
  TrackerEmulator tracker(recorded_sample);
  EXPECT_EQ(text_of(tracker.tick(0)), named("derived_WakeUp"));
  EXPECT_TRUE(tracker.receive(bytes_of(named("derived_WakeUpAck")), 1000).empty());
  const std::pair<const char*, const char*> kDialogue[] = {
      {"vendor_GoToConfig", "mti300_GoToConfigAck"},
      {"derived_ReqDID", "mti30_DeviceID"},
      {"derived_ReqProductCode", "mti30_ProductCode"},
      {"derived_SetOutputSettings_quat_counter", "derived_Error_message_invalid"},
      {"vendor_SetBaudrate_921600", "vendor_SetBaudrateAck"},
      {"vendor_GoToMeasurement", "mti300_GotoMeasurementAck"},
      {"derived_ReqDID", "derived_Error_message_invalid"},
      {"vendor_GoToConfig", "vendor_GoToConfigAck"}};
  for (const auto& [request, answer] : kDialogue) {
    // Measured at this moment, too, after the way to measure: which comes before the answer.
    const std::string heard = text_of(tracker.receive(bytes_of(named(request)), 2000));
    EXPECT_TRUE(heard.ends_with(named(answer))) << request << ' ' << hex_of(heard);
  }
  // Number and settings of another device of the series.
  EXPECT_EQ(tracker.receive(bytes_of(named("derived_ReqFWRev")), 3000).size(), named("mti300_FirmwareRev").size());
  EXPECT_EQ(tracker.receive(bytes_of(named("derived_ReqConfiguration")), 3000).size(),
            named("mti30_Configuration").size());
}

TEST(TrackerEmulator, GreetsAndThenMeasuresAsStored) {
  TrackerEmulator tracker(recorded_sample);
  tracker.tick(0);
  EXPECT_TRUE(tracker.tick(499'000).empty());
  EXPECT_FALSE(tracker.tick(500'000).empty());
  EXPECT_TRUE(tracker.measuring());
  EXPECT_TRUE(tracker.tick(505'000).empty());
  EXPECT_FALSE(tracker.tick(510'000).empty());
}

class BothGenerations : public testing::TestWithParam<TrackerEmulator::Generation> {};

TEST_P(BothGenerations, TheBridgeHearsTheOrientationOverATerminal) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(0.8, -0.3, 0.4, 0.33).normalized();
  TrackerEmulator tracker(
      [&](std::int64_t sample, Utime) {
        TrackerSample measured;
        measured.q_world_sensor = q;
        measured.acceleration = q.conjugate() * Eigen::Vector3d(0, 0, 9.81);
        measured.rate_of_turn = {0.001 * static_cast<double>(sample % 100), -0.2, 0.3};
        return measured;
      },
      GetParam());
  ScratchFolder folder;
  TerminalEnd end(folder / "tracker");
  xsens::TrackerDevice device({end.link(), 0}, {});
  std::vector<xsens::TimedReading> readings;
  const Utime began = steady_now();
  while (readings.size() < 100 && steady_now() - began < 20 * kMicrosecondsPerSecond) {
    const Utime now = steady_now() - began;
    end.say(tracker.receive(end.hear(), now));
    end.say(tracker.tick(now));
    for (auto& reading : device.run(1).readings) readings.push_back(std::move(reading));
  }
  ASSERT_GE(readings.size(), 100U);
  // That it does not know the current settings is by what the older generation is known.
  EXPECT_EQ(device.counters().errors, GetParam() == TrackerEmulator::Generation::older ? 1U : 0U);
  EXPECT_EQ(device.bad_messages(), 0U);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const xsens::TrackerReading& reading = readings[i].reading;
    ASSERT_TRUE(reading.q_world_sensor && reading.acceleration && reading.rate_of_turn && reading.packet_counter);
    EXPECT_LT(reading.q_world_sensor->angularDistance(q), 1e-6);
    EXPECT_LT((q * *reading.acceleration - Eigen::Vector3d(0, 0, 9.81)).norm(), 1e-5);
    EXPECT_NEAR(reading.rate_of_turn->y(), -0.2, 1e-6);
    const xsens::TrackerReading& before = readings[i == 0 ? 0 : i - 1].reading;
    EXPECT_EQ(static_cast<std::uint16_t>(*reading.packet_counter - *before.packet_counter), i == 0 ? 0 : 1);
    if (GetParam() == TrackerEmulator::Generation::older) continue;  // It tells neither health nor time.
    EXPECT_TRUE(reading.healthy());
    EXPECT_EQ(*reading.sample_time_fine - *before.sample_time_fine, i == 0 ? 0U : 100U);
  }
}

INSTANTIATE_TEST_SUITE_P(Trackers, BothGenerations,
                         testing::Values(TrackerEmulator::Generation::older, TrackerEmulator::Generation::current),
                         [](const auto& generation) {
                           return generation.param == TrackerEmulator::Generation::older ? "MTData" : "MTData2";
                         });

/// A recorded message's numbers, by the sheet's layout of its mode, written again.
TEST(TrackerEmulator, TheRecordedMtDataByteForByte) {
  SKIP_WITHOUT_FACTS();
  const std::string recorded = unhex(
      "FAFF32363D618499BD2559AD411D13ED3B1B5260BAC11234BB7F213FBE3A38CC3E49C10CBEA3FCDA3E8BAD87BB5302CB3BF3D3BABF7647E0"
      "4B3341");
  BigEndianReader reader(bytes_of(recorded).subspan(4));
  const auto next = [&] { return static_cast<double>(reader.f32()); };
  TrackerSample sample;
  for (Eigen::Vector3d* triple : {&sample.acceleration, &sample.rate_of_turn, &sample.magnetic_field}) {
    for (int axis = 0; axis < 3; ++axis) (*triple)[axis] = next();
  }
  const double w = next(), x = next(), y = next(), z = next();
  const double s = std::sqrt(0.5);  // From x north to x east.
  sample.q_world_sensor = Eigen::Quaterniond(s, 0, 0, s) * Eigen::Quaterniond(w, x, y, z);
  MtDataOutput output;
  ASSERT_TRUE(output.answer({0xD0, {0x00, 0x06}}) && output.answer({0xD2, {0, 0, 0, 1}}));
  const std::string written = text_of(output.message(sample, {0, 19251, 0}));
  // The quaternion has been turned there and back, which may cost its last bit.
  EXPECT_EQ(hex_of(written.substr(0, 40)), hex_of(recorded.substr(0, 40)));
  EXPECT_EQ(written.size(), recorded.size());
  EXPECT_EQ(hex_of(written.substr(56, 2)), hex_of(recorded.substr(56, 2)));
  BigEndianReader quaternion(bytes_of(written).subspan(40));
  for (const double expected : {w, x, y, z}) EXPECT_NEAR(static_cast<double>(quaternion.f32()), expected, 1e-7);
}

}  // namespace
}  // namespace scanway::test
