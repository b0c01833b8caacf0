#include "modules/xsens_bridge/core/reading.h"

#include <cmath>

#include "common/random/random.h"
#include "modules/xsens_bridge/core/mtdata.h"
#include "modules/xsens_bridge/core/mtdata2.h"
#include "tests/modules/xsens_bridge/shared_xsens.h"

namespace scanway::test {
namespace {

using xsens::EarthFrame;
using xsens::Item;
using xsens::Numbers;
using xsens::Quantity;

Item item_of(Quantity quantity, Numbers numbers, EarthFrame frame = EarthFrame::enu) {
  Item item;
  item.quantity = quantity;
  item.frame = frame;
  item.value = std::move(numbers);
  return item;
}

double angle_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.angularDistance(b); }

Eigen::Quaterniond orientation(const std::vector<Item>& items) {
  return xsens::make_reading(items).q_world_sensor.value();
}

TEST(Reading, QuaternionMatrixAndAnglesOfARecordedMessageAgree) {
  SKIP_WITHOUT_XSENS_FACTS();
  const auto items = xsens::parse_mtdata2(xsens_message("derived_MTData2_extended_length").data);
  const Eigen::Quaterniond q = orientation({*find_item(items, Quantity::quaternion)});
  EXPECT_LT(angle_between(q, orientation({*find_item(items, Quantity::rotation_matrix)})), 1e-7);
  EXPECT_LT(angle_between(q, orientation({*find_item(items, Quantity::euler)})), 1e-7);
}

TEST(Reading, AnglesAreYawThenPitchThenRoll) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const double roll = 360.0 * random.uniform() - 180.0, pitch = 178.0 * random.uniform() - 89.0,
                 yaw = 360.0 * random.uniform() - 180.0;
    const auto q = orientation({item_of(Quantity::euler, {roll, pitch, yaw})});
    // The sheet's formulas, the other way round.
    const double w = q.w(), x = q.x(), y = q.y(), z = q.z(), degree = M_PI / 180.0;
    EXPECT_NEAR(std::remainder(std::atan2(2 * (y * z + w * x), 2 * w * w + 2 * z * z - 1) - roll * degree, 2 * M_PI),
                0.0, 1e-9);
    EXPECT_NEAR(-std::asin(2 * (x * z - w * y)), pitch * degree, 1e-7);
    EXPECT_NEAR(std::remainder(std::atan2(2 * (x * y + w * z), 2 * w * w + 2 * x * x - 1) - yaw * degree, 2 * M_PI),
                0.0, 1e-9);
  }
}

TEST(Reading, EveryEarthFrameBecomesOneWithZUp) {
  // A level sensor that looks north: in each frame its axes are where that frame says.
  const Eigen::Vector3d north(0, 1, 0), up(0, 0, 1);
  const double half = std::sqrt(0.5);
  struct Case {
    EarthFrame frame;
    Numbers q;
    Eigen::Vector3d sensor_up;
  };
  for (const Case& known :
       {Case{EarthFrame::enu, {half, 0, 0, half}, {0, 0, 1}}, Case{EarthFrame::nwu, {1, 0, 0, 0}, {0, 0, 1}},
        Case{EarthFrame::ned, {1, 0, 0, 0}, {0, 0, -1}}}) {
    const auto q = orientation({item_of(Quantity::quaternion, known.q, known.frame)});
    EXPECT_LT((q * Eigen::Vector3d(1, 0, 0) - north).norm(), 1e-12);
    EXPECT_LT((q * known.sensor_up - up).norm(), 1e-12);
  }
}

TEST(Reading, GravityPointsUpInRecordedMessages) {
  SKIP_WITHOUT_XSENS_FACTS();
  for (const char* name :
       {"mti300_mdata2_full", "legacy_mtig_MTData_calib_quat_counter", "legacy_mti_MTData_acc_gyr_euler"}) {
    const auto message = xsens_message(name);
    const auto items = message.mid == xsens::kMtData2
                           ? xsens::parse_mtdata2(message.data)
                           : xsens::parse_mtdata(message.data, xsens::guess_layout(message.data).value());
    const auto reading = xsens::make_reading(items);
    const Eigen::Vector3d up = *reading.q_world_sensor * reading.acceleration->normalized();
    EXPECT_LT(std::acos(up.z()) * 180.0 / M_PI, 1.0) << name;
  }
}

TEST(Reading, WhatIsNoRotationIsNoOrientation) {
  const double nan = std::nan("");
  EXPECT_FALSE(xsens::make_reading(std::vector{item_of(Quantity::quaternion, {2, 0, 0, 0})}).q_world_sensor);
  EXPECT_FALSE(xsens::make_reading(std::vector{item_of(Quantity::quaternion, {nan, 0, 0, 1})}).q_world_sensor);
  EXPECT_FALSE(xsens::make_reading(std::vector{item_of(Quantity::euler, {nan, 0, 0})}).q_world_sensor);
  const Numbers mirrored{1, 0, 0, 0, 1, 0, 0, 0, -1};
  EXPECT_FALSE(xsens::make_reading(std::vector{item_of(Quantity::rotation_matrix, mirrored)}).q_world_sensor);
  EXPECT_FALSE(xsens::make_reading({}).q_world_sensor);
}

TEST(Reading, AnInvalidFilterAndClippingCostTrust) {
  std::vector<Item> items{item_of(Quantity::quaternion, {1, 0, 0, 0}), Item{}};
  items[1].quantity = Quantity::status_word;
  const auto sigma = [&](std::uint32_t status) {
    items[1].value = xsens::BitField{status};
    return xsens::make_reading(items).tilt_sigma;
  };
  EXPECT_NEAR(sigma(0x00400003), 0.5 * M_PI / 180.0, 1e-12);
  EXPECT_GT(sigma(0x00000001), sigma(0x00000003));
  EXPECT_GT(sigma(0x00080103), sigma(0x00000003));
}

TEST(Reading, GnssMessagesHaveNoOrientationAndAnOlderTime) {
  SKIP_WITHOUT_XSENS_FACTS();
  const std::string bytes = read_text(kXsensFacts + "captures/mtig710-euler-float32.bin");
  FrameFinder finder = xsens::make_frame_finder();
  finder.push(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
  std::optional<xsens::TrackerReading> last;
  int steps_back = 0;
  while (const auto stretch = finder.next()) {
    const auto reading = xsens::make_reading(xsens::parse_mtdata2(xsens::open_frame(stretch->bytes).data));
    if (last) {
      EXPECT_EQ(static_cast<std::uint16_t>(*reading.packet_counter - *last->packet_counter), 1);
      if (*reading.sample_time_fine < *last->sample_time_fine) {
        ++steps_back;
        EXPECT_FALSE(reading.q_world_sensor);
      }
    }
    last = reading;
  }
  EXPECT_EQ(steps_back, 4);
}

}  // namespace
}  // namespace scanway::test
