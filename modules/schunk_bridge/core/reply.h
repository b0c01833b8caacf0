#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "modules/schunk_bridge/core/message.h"
#include "modules/schunk_bridge/core/units.h"

namespace scanway::schunk {

/// What messages of a module can say. Numbers are in the module's own unit system.
namespace reply {

struct Ok {};
/// The command was not carried out.
struct Failure {
  std::uint8_t code = 0;
};
/// CMD ERROR, CMD WARNING or CMD INFO. `asked`: it is in the form that answers a command, too.
struct Alert {
  std::uint8_t code = 0;
  bool asked = false;
};
struct State {
  std::optional<double> position, velocity, current_A;
  std::uint8_t bits = 0;
  std::uint8_t error = 0;
};
/// How long the move will take.
struct Duration {
  double seconds = 0;
};
/// CMD POS REACHED or CMD MOVE BLOCKED: where the axis stands.
struct Standing {
  double position = 0;
};
struct DetailedError {
  Command kind{};  ///< CMD ERROR, CMD WARNING or CMD INFO.
  std::uint8_t code = 0;
  double data = 0;
};
struct SettingValue {
  Setting setting{};
  double value = 0;
  std::vector<std::uint8_t> bytes;  ///< As they came; all that there is when the form is `bytes`.
};
struct SettingTaken {
  Setting setting{};
};
struct ModuleInfo {
  std::string type;
  std::uint32_t order_number = 0;
  double firmware = 0, protocol = 0, hardware = 0;  ///< Versions.
  std::string date;
};
/// CMD TOGGLE IMPULSE MESSAGE: whether impulses come from now on.
struct Impulses {
  bool on = false;
};
/// CHANGE USER: 0 user, 1 diagnosis, 2 professional, 3 advanced.
struct User {
  int level = 0;
};
/// A message whose content the protocol sheet does not explain.
struct Unexplained {};
/// A message that contradicts the protocol.
struct Malformed {
  std::string reason;
};

}  // namespace reply

using Reply = std::variant<reply::Ok, reply::Failure, reply::Alert, reply::State, reply::Duration, reply::Standing,
                           reply::DetailedError, reply::SettingValue, reply::SettingTaken, reply::ModuleInfo,
                           reply::Impulses, reply::User, reply::Unexplained, reply::Malformed>;

/// What a module says. `mask` is what its state was asked to hold: the message itself does not say.
Reply parse_reply(const Message& message, std::uint8_t mask, UnitSystem units);

/// How many numbers a state of that mask holds.
int numbers_in(std::uint8_t mask);

}  // namespace scanway::schunk
