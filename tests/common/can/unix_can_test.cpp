// The pretended CAN bus: what SocketCAN does on a real one (schunk_bridge_can_test), over a socket.

#include <linux/can.h>
#include <linux/can/error.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <chrono>

#include "common/can/can_link.h"
#include "common/files/input_error.h"
#include "tests/support/command.h"

namespace scanway {
namespace {

CanFrame frame_of(std::uint16_t id, std::uint8_t first) {
  CanFrame frame;
  frame.id = id;
  frame.size = 2;
  frame.data[0] = first;
  return frame;
}

std::string complaint(const auto& what) {
  try {
    what();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

sockaddr_un address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  return address;
}

Utime wall_clock() {
  using namespace std::chrono;
  return duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
}

class UnixCan : public testing::Test {
 protected:
  /// What an end gets while the hub does its work.
  std::optional<CanLink::Received> next(CanLink& end) {
    for (int i = 0; i < 200; ++i) {
      if (auto received = end.receive(0)) return received;
      if (&end != hub_.get() && hub_) hub_->receive(1);
    }
    return std::nullopt;
  }

  const test::ScratchFolder folder_;
  const std::string name_ = "unix:" + folder_ / "can";
  std::unique_ptr<CanLink> hub_ = serve_can(name_);
};

TEST_F(UnixCan, EveryEndHearsEveryOtherOne) {
  const auto a = open_can(name_), b = open_can(name_);
  while (hub_->receive(5)) {
  }
  hub_->receive(0);
  ASSERT_TRUE(hub_->send(frame_of(0x70B, 1)));
  for (const auto& end : {a.get(), b.get()}) {
    const auto received = next(*end);
    ASSERT_TRUE(received && received->frame);
    EXPECT_EQ(*received->frame, frame_of(0x70B, 1));
  }
  ASSERT_TRUE(a->send(frame_of(0x50B, 2)));
  const auto at_hub = next(*hub_);
  ASSERT_TRUE(at_hub && at_hub->frame);
  EXPECT_EQ(*at_hub->frame, frame_of(0x50B, 2));
  const auto at_b = next(*b);
  ASSERT_TRUE(at_b && at_b->frame);
  EXPECT_EQ(*at_b->frame, frame_of(0x50B, 2));
  EXPECT_FALSE(a->receive(5));
}

TEST_F(UnixCan, HearsOnlyWhatItAskedFor) {
  const auto end = open_can(name_, {0x70B});
  hub_->receive(100);
  hub_->send(frame_of(0x70C, 1));
  hub_->send(frame_of(0x70B, 2));
  const auto received = next(*end);
  ASSERT_TRUE(received && received->frame);
  EXPECT_EQ(received->frame->id, 0x70B);
  EXPECT_FALSE(end->receive(5));
}

TEST_F(UnixCan, ATimeIsThatOfSendingHoweverLateItIsFetched) {
  const auto end = open_can(name_);
  hub_->receive(100);
  const Utime before = wall_clock();
  hub_->send(frame_of(0x70B, 1));
  const Utime after = wall_clock();
  usleep(30'000);
  const auto received = next(*end);
  ASSERT_TRUE(received);
  EXPECT_GE(received->utime, before);
  EXPECT_LE(received->utime, after);
}

TEST_F(UnixCan, TheFrameOnTheWireIsTheKernelsOwn) {
  const int raw = socket(AF_UNIX, SOCK_SEQPACKET, 0);
  const sockaddr_un address = address_of(folder_ / "can");
  ASSERT_EQ(connect(raw, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  hub_->receive(100);
  hub_->send(frame_of(0x70B, 7));
  can_frame frame{};
  ASSERT_EQ(read(raw, &frame, sizeof frame), 16);
  EXPECT_EQ(frame.can_id, 0x70Bu);
  EXPECT_EQ(frame.len, 2);
  EXPECT_EQ(frame.data[0], 7);
  // Error frames come through; what is no frame, of 29 bits or without data is passed over.
  frame.can_id = CAN_ERR_FLAG | CAN_ERR_BUSOFF;
  ASSERT_EQ(write(raw, &frame, sizeof frame), 16);
  auto received = next(*hub_);
  ASSERT_TRUE(received);
  EXPECT_EQ(received->error, static_cast<std::uint32_t>(CAN_ERR_BUSOFF));
  EXPECT_FALSE(received->frame);
  ASSERT_EQ(write(raw, "short", 5), 5);
  frame.can_id = 0x123 | CAN_EFF_FLAG;
  ASSERT_EQ(write(raw, &frame, sizeof frame), 16);
  frame.can_id = 0x123;
  frame.len = 200;
  ASSERT_EQ(write(raw, &frame, sizeof frame), 16);
  do {
    received = next(*hub_);
    ASSERT_TRUE(received);
  } while (!received->frame);
  EXPECT_EQ(received->frame->id, 0x123);
  EXPECT_EQ(received->frame->size, 8);
  close(raw);
}

TEST_F(UnixCan, AnEndMayGoAndTheHubMayGo) {
  auto end = open_can(name_), other = open_can(name_);
  hub_->receive(100);
  hub_->receive(100);
  end.reset();
  EXPECT_FALSE(hub_->receive(100));
  EXPECT_TRUE(hub_->send(frame_of(0x70B, 1)));
  ASSERT_TRUE(next(*other));
  hub_.reset();
  EXPECT_NE(complaint([&] { other->receive(10); }).find("served no longer"), std::string::npos);
  EXPECT_NE(complaint([&] { open_can(name_); }).find("no bus is served there"), std::string::npos);
}

TEST_F(UnixCan, AnEndThatDoesNotFetchStopsNobody) {
  const auto idle = open_can(name_), busy = open_can(name_);
  hub_->receive(100);
  hub_->receive(100);
  for (int i = 0; i < 5000; ++i) {
    ASSERT_TRUE(hub_->send(frame_of(0x70B, static_cast<std::uint8_t>(i))));
    const auto received = busy->receive(0);
    ASSERT_TRUE(received && received->frame);
    EXPECT_EQ(received->frame->data[0], static_cast<std::uint8_t>(i));
  }
}

TEST_F(UnixCan, NamesWhatIsWrongInOneLine) {
  EXPECT_NE(complaint([&] { serve_can(name_); }).find("another program serves"), std::string::npos);
  EXPECT_NE(complaint([] { open_can("unix:"); }).find("names no socket"), std::string::npos);
  EXPECT_NE(complaint([] { serve_can("unix:/" + std::string(200, 'x')); }).find("at most 107"), std::string::npos);
  EXPECT_NE(complaint([] { serve_can("unix:/nowhere/at/all"); }).find("cannot be served"), std::string::npos);
  const std::string file = folder_ / "file";
  EXPECT_EQ(test::run_command({"touch", file}).status, 0);
  EXPECT_NE(complaint([&] { serve_can("unix:" + file); }).find("another kind"), std::string::npos);
  EXPECT_EQ(access(file.c_str(), F_OK), 0);
  // What a killed program left behind is in nobody's way.
  const std::string left = folder_ / "left";
  const sockaddr_un address = address_of(left);
  const int dead = socket(AF_UNIX, SOCK_SEQPACKET, 0);
  ASSERT_EQ(bind(dead, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  close(dead);
  EXPECT_EQ(complaint([&] { serve_can("unix:" + left); }), "");
}

}  // namespace
}  // namespace scanway
