#include "modules/mapper/core/movement/movement.h"

#include <cstdio>

#include "common/math/repeatable.h"

namespace scanway {
namespace {

constexpr double kRightMetres = 0.1, kRightDegrees = 0.5;  // as the verdict's

double degrees(double radians) { return radians * 180.0 / repeatable::kPi; }

std::string said_of_robot(const RobotMovement& robot, const std::string& or_during) {
  char text[160];
  std::snprintf(text, sizeof(text), ", about %.0f s after its begin: by %.0f cm and %.1f degrees.", robot.after_s,
                100.0 * robot.shift_m, degrees(robot.turn_rad));
  const std::string said = " The robot moved during the sweep";
  return said + (or_during.empty() ? "" : ", or during " + or_during) + text;
}

std::string said_of_scene(const SceneMovement& scene) {
  char text[200];
  std::snprintf(text, sizeof(text), " Things moved: %zu came, %zu went (%.2f %% of the points).", scene.came,
                scene.gone, 100.0 * scene.share);
  return text;
}

}  // namespace

bool breaks_sweep(const RobotMovement& movement) {
  return movement.moved && (movement.shift_m > kRightMetres || degrees(movement.turn_rad) > kRightDegrees);
}

std::string said_of(const Movement& movement) {
  std::string said;
  if (movement.robot.moved) said += said_of_robot(movement.robot, movement.or_during);
  if (movement.scene.moved()) said += said_of_scene(movement.scene);
  return said;
}

}  // namespace scanway
