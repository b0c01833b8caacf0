#include "common/messages/pose_message.h"

#include "common/messages/bad_message.h"
#include "common/messages/rigid.h"

namespace scanway {

bot_core::pose_t pose_message(Utime utime, const Pose& X) {
  bot_core::pose_t message{};
  message.utime = utime;
  for (int i = 0; i < 3; ++i) message.pos[i] = X.translation()[i];
  put_quaternion(Eigen::Quaterniond(X.linear()), message.orientation);
  return message;
}

Pose pose_of(const bot_core::pose_t& message) {
  const Eigen::Vector3d position(message.pos[0], message.pos[1], message.pos[2]);
  if (!position.allFinite()) throw BadMessage("a pose whose position is not finite");
  Pose X = Pose::Identity();
  X.linear() = get_quaternion(message.orientation).toRotationMatrix();
  X.translation() = position;
  return X;
}

}  // namespace scanway
