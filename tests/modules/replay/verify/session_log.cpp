#include "tests/modules/replay/verify/session_log.h"

#include "common/bus/channels.h"
#include "common/bus/log_bus.h"
#include "common/messages/codec.h"
#include "common/messages/goal_message.h"
#include "common/messages/imu_message.h"
#include "common/messages/objects.h"
#include "common/messages/sweep_message.h"
#include "common/random/random.h"
#include "modules/replay/replay.h"

namespace scanway::test {
namespace {

/// A floor and four walls around the sensor, which stands 1 m above the floor at (x, 0) in the room.
Sweep room(Utime utime, const std::string& name, double x) {
  Random random(static_cast<std::uint64_t>(utime));
  Sweep sweep;
  sweep.name = name;
  sweep.utime = utime;
  const auto add = [&](double px, double py, double pz) {
    sweep.cloud.points.emplace_back(static_cast<float>(px - x), static_cast<float>(py), static_cast<float>(pz));
  };
  for (int i = 0; i < 4000; ++i) {
    const double u = 4.0 * random.uniform() - 2.0, v = 3.0 * random.uniform() - 1.5, h = 2.0 * random.uniform() - 1.0;
    add(u, v, -1.0);
    add(u, random.uniform() < 0.5 ? -1.5 : 1.5, h);
    add(random.uniform() < 0.5 ? -2.0 : 2.0, v, h);
  }
  return sweep;
}

void write_inputs(const std::string& path) {
  LogWriter log(path);
  LogBus bus(log);
  const auto send = [&](const Channel& channel, const auto& message, Utime utime) {
    bus.publish(channel.name, encode(message), utime);
  };
  send(channel::kGoal, goal_message(kFirstSweep - kMicrosecondsPerSecond, {0.8, 0.4}),
       kFirstSweep - kMicrosecondsPerSecond);
  std::int64_t version = 0;
  for (const Utime utime : {kFirstSweep, kSecondSweep}) {
    const std::string name = utime == kFirstSweep ? "first" : "second";
    send(channel::kImu, imu_message(utime - kImuBefore, Eigen::Quaterniond::Identity()), utime - kImuBefore);
    publish_object(bus, channel::kSweep, encode(to_message(room(utime, name, utime == kFirstSweep ? 0.0 : 0.1))), name,
                   ++version, utime);
  }
  log.close();
}

}  // namespace

const SessionLog& SessionLog::get() {
  static const SessionLog kLog;
  return kLog;
}

SessionLog::SessionLog() : path_(folder_ / "session.lcmlog"), inputs_path_(folder_ / "inputs.lcmlog") {
  write_inputs(inputs_path_);
  LogWriter recording(path_);
  Replay replay(Robot{}, recording);
  LogReader inputs(inputs_path_);
  replay.run(inputs);
  recording.close();
}

std::string SessionLog::edited(const std::string& name,
                               const std::function<void(std::vector<EditedEvent>&)>& edit) const {
  std::vector<EditedEvent> events;
  LogReader log(path_);
  while (const auto event = log.next()) {
    events.push_back({std::string(event->channel), event->utime, {event->bytes.begin(), event->bytes.end()}});
  }
  edit(events);
  const std::string path = folder_ / name;
  LogWriter writer(path);
  for (const EditedEvent& event : events) writer.write(event.channel, event.bytes, event.utime);
  writer.close();
  return path;
}

std::vector<EditedEvent*> events_of(std::vector<EditedEvent>& events, std::string_view channel) {
  std::vector<EditedEvent*> found;
  for (EditedEvent& event : events) {
    if (event.channel == channel) found.push_back(&event);
  }
  return found;
}

}  // namespace scanway::test
