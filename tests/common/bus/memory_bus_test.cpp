#include "common/bus/memory_bus.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace scanway {
namespace {

std::vector<std::uint8_t> payload(const std::string& text) { return {text.begin(), text.end()}; }

std::string shown(const BusMessage& message) {
  return std::string(message.channel) + ":" + std::string(message.bytes.begin(), message.bytes.end()) + "@" +
         std::to_string(message.utime);
}

TEST(MemoryBus, DeliversInTheOrderOfPublishing) {
  MemoryBus bus;
  std::vector<std::string> got;
  const auto keep = [&](const BusMessage& message) { got.push_back(shown(message)); };
  bus.subscribe("A", keep);
  bus.subscribe("B", keep);
  bus.publish("B", payload("1"), 10);
  bus.publish("C", payload("2"), 9);
  bus.publish("A", payload("3"), 8);
  bus.publish("B", payload(""), 7);
  EXPECT_TRUE(got.empty());
  EXPECT_EQ(bus.dispatch(), 4U);
  EXPECT_EQ(got, (std::vector<std::string>{"B:1@10", "A:3@8", "B:@7"}));
  EXPECT_EQ(bus.dispatch(), 0U);
}

TEST(MemoryBus, LetsHandlersPublishAndSubscribe) {
  MemoryBus bus;
  std::vector<std::string> got;
  bus.subscribe("A", [&](const BusMessage& message) {
    got.push_back(shown(message));
    if (message.utime < 3) bus.publish("A", message.bytes, message.utime + 1);
    if (message.utime == 1) bus.subscribe("A", [&](const BusMessage& late) { got.push_back("late " + shown(late)); });
  });
  bus.publish("A", payload("x"), 1);
  EXPECT_EQ(bus.dispatch(), 3U);
  EXPECT_EQ(got, (std::vector<std::string>{"A:x@1", "A:x@2", "late A:x@2", "A:x@3", "late A:x@3"}));
}

TEST(MemoryBus, GoesOnAfterAHandlerThatThrows) {
  MemoryBus bus;
  int got = 0;
  bus.subscribe("A", [&](const BusMessage&) {
    if (++got == 1) throw std::runtime_error("once");
  });
  bus.publish("A", {}, 1);
  bus.publish("A", {}, 2);
  EXPECT_THROW(bus.dispatch(), std::runtime_error);
  EXPECT_EQ(bus.dispatch(), 1U);
  EXPECT_EQ(got, 2);
}

}  // namespace
}  // namespace scanway
