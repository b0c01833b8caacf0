// The bus over LCM without a network: within the process (memq). What needs a network is in tests/live.
#include "common/bus/lcm_bus.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "common/bus/lcm_url.h"
#include "common/files/input_error.h"

namespace scanway {
namespace {

constexpr auto kWait = std::chrono::milliseconds(20);
constexpr int kPatience = 500;  // times kWait, without a message

/// Delivers until `ready` or nothing more comes.
template <class Ready>
void dispatch_until(LcmBus& bus, const Ready& ready) {
  for (int idle = 0; idle < kPatience && !ready();) idle = bus.dispatch(kWait) == 0 ? idle + 1 : 0;
}

std::vector<std::uint8_t> number(int i) { return {static_cast<std::uint8_t>(i >> 8), static_cast<std::uint8_t>(i)}; }

TEST(LcmBus, LosesNothingOfABurstAndKeepsTheOrder) {
  LcmBus bus("memq://");
  std::vector<std::vector<std::uint8_t>> heard;
  bus.subscribe("BURST", [&](const BusMessage& message) {
    EXPECT_EQ(message.channel, "BURST");
    heard.emplace_back(message.bytes.begin(), message.bytes.end());
  });
  constexpr int kBurst = 5000;  // Far beyond the 30 that LCM keeps by itself.
  for (int i = 0; i < kBurst; ++i) bus.publish("BURST", number(i), 0);
  dispatch_until(bus, [&] { return heard.size() >= kBurst; });
  ASSERT_EQ(heard.size(), static_cast<std::size_t>(kBurst));
  for (int i = 0; i < kBurst; ++i) EXPECT_EQ(heard[static_cast<std::size_t>(i)], number(i));
}

TEST(LcmBus, AChannelIsItsExactName) {
  LcmBus bus("memq://");
  std::string heard;
  for (const char* channel : {"A.B", "A", "AXB"}) {
    bus.subscribe(channel, [&heard, channel](const BusMessage&) { heard += std::string(channel) + " "; });
  }
  bus.publish("AXB", number(1), 0);
  bus.publish("A", number(2), 0);
  bus.publish("AB", number(3), 0);
  bus.publish("A.B", number(4), 0);
  dispatch_until(bus, [&] { return heard.size() >= 10; });
  EXPECT_EQ(heard, "AXB A A.B ");
}

TEST(LcmBus, EachHandlerOfAChannelGetsAMessageOnce) {
  LcmBus bus("memq://");
  int first = 0, second = 0, last = 0;
  bus.subscribe("SHARED", [&](const BusMessage&) { ++first; });
  bus.subscribe("SHARED", [&](const BusMessage&) { ++second; });
  bus.subscribe("LAST", [&](const BusMessage&) { ++last; });
  for (int i = 0; i < 10; ++i) bus.publish("SHARED", number(i), 0);
  bus.publish("LAST", number(0), 0);
  dispatch_until(bus, [&] { return last > 0; });
  EXPECT_EQ(first, 10);
  EXPECT_EQ(second, 10);
}

TEST(LcmBus, AnyThreadMayPublish) {
  LcmBus bus("memq://");
  std::size_t heard = 0;
  bus.subscribe("MANY", [&](const BusMessage&) { ++heard; });
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&bus] {
      for (int i = 0; i < 500; ++i) bus.publish("MANY", number(i), 0);
    });
  }
  for (std::thread& thread : threads) thread.join();
  dispatch_until(bus, [&] { return heard >= 2000; });
  EXPECT_EQ(heard, 2000U);
  EXPECT_EQ(bus.failed_publications(), 0U);
}

TEST(LcmBus, DispatchReturnsWhenNothingComes) {
  LcmBus bus("memq://");
  EXPECT_EQ(bus.dispatch(std::chrono::milliseconds(1)), 0U);
}

TEST(LcmUrl, WhatIsNoBusIsRefused) {
  for (const char* url : {"", "nonsense", "xyz://", "udpm://1.2.3.4:7667", "udpm://239.255.76.67:0", "file://log",
                          "udpm://239.255.76.67:70000", "udpm://host:7667", "tcpq://", "tcpq://127.0.0.1:1"}) {
    EXPECT_THROW(check_lcm_url(url), InputError) << url;
  }
  EXPECT_NO_THROW(check_lcm_url("memq://"));
}

TEST(LcmUrl, AsksForABufferUnlessTheUrlDoes) {
  EXPECT_EQ(with_receive_buffer("udpm://239.255.76.67:7667?ttl=1", 4096),
            "udpm://239.255.76.67:7667?ttl=1&recv_buf_size=4096");
  EXPECT_EQ(with_receive_buffer("udpm://239.255.76.67:7667", 4096), "udpm://239.255.76.67:7667?recv_buf_size=4096");
  EXPECT_EQ(with_receive_buffer("udpm://?recv_buf_size=1", 4096), "udpm://?recv_buf_size=1");
  EXPECT_EQ(with_receive_buffer("memq://", 4096), "memq://");
}

TEST(LcmUrl, ABufferThatIsTooSmallComesWithTheLineThatMendsIt) {
  const std::string advice = receive_buffer_advice("udpm://239.255.76.67:7667?ttl=1", 212992);
  EXPECT_NE(advice.find("208 kB"), std::string::npos) << advice;
  EXPECT_NE(advice.find("sysctl -w net.core.rmem_max=8388608"), std::string::npos) << advice;
  EXPECT_EQ(advice.find('\n'), std::string::npos);
  EXPECT_EQ(receive_buffer_advice("udpm://239.255.76.67:7667", std::size_t{4} << 20), "");
  EXPECT_EQ(receive_buffer_advice("tcpq://localhost:7700", 1000), "");
}

TEST(LcmUrl, TheBufferThatTheKernelGrantsIsAtMostWhatWasAsked) {
  EXPECT_LE(granted_receive_buffer(65536), 65536U);
  EXPECT_GT(granted_receive_buffer(65536), 4096U);
}

}  // namespace
}  // namespace scanway
