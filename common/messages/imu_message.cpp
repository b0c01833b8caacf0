#include "common/messages/imu_message.h"

#include <limits>

#include "common/messages/rigid.h"

namespace scanway {

bot_core::ins_t imu_message(Utime utime, const Eigen::Quaterniond& R_world_body) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  bot_core::ins_t message{};
  message.utime = utime;
  for (int i = 0; i < 3; ++i) message.gyro[i] = message.mag[i] = message.accel[i] = kUnknown;
  put_quaternion(R_world_body, message.quat);
  message.pressure = kUnknown;
  message.rel_alt = kUnknown;
  return message;
}

Eigen::Quaterniond orientation_of(const bot_core::ins_t& message) { return get_quaternion(message.quat); }

}  // namespace scanway
