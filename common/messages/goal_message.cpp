#include "common/messages/goal_message.h"

#include "common/messages/bad_message.h"

namespace scanway {

goal_t goal_message(Utime utime, const Eigen::Vector2d& goal) {
  goal_t message{};
  message.utime = utime;
  message.goal_x_m = goal.x();
  message.goal_y_m = goal.y();
  return message;
}

Eigen::Vector2d goal_of(const goal_t& message) {
  const Eigen::Vector2d goal(message.goal_x_m, message.goal_y_m);
  if (!goal.allFinite()) throw BadMessage("a goal that is not finite");
  return goal;
}

}  // namespace scanway
