#pragma once

#include <cstdint>
#include <initializer_list>

#include "modules/schunk_bridge/core/message.h"
#include "modules/schunk_bridge/core/units.h"

/// The messages that a master sends. Values are in the module's own unit system.
namespace scanway::schunk::request {

/// A command without parameters: CMD REFERENCE, CMD STOP, CMD FAST STOP, CMD ACK, CMD REBOOT, GET DETAILED ERROR INFO,
/// CMD TOGGLE IMPULSE MESSAGE, GET CONFIG (of the module's type and firmware).
Message plain(std::uint8_t module, Command command);
Message get_config(std::uint8_t module, Setting setting);
/// `value` is taken by the setting's form (form_of).
Message set_config(std::uint8_t module, Setting setting, double value, UnitSystem units);
/// The state every `period_s`, 0: once and no longer. `mask` by state_mask.
Message get_state(std::uint8_t module, double period_s, std::uint8_t mask, UnitSystem units);
/// SET TARGET VEL, ACC or JERK, MOVE POS, MOVE POS REL or MOVE VEL with what follows its first value: any number of
/// values makes a message; more than one needs fragments.
Message with_values(std::uint8_t module, Command command, std::initializer_list<double> values, UnitSystem units);
/// SET TARGET CUR and MOVE CUR, amperes.
Message with_current(std::uint8_t module, Command command, double amperes, UnitSystem units);
/// SET TARGET TIME.
Message set_target_time(std::uint8_t module, double seconds, UnitSystem units);

}  // namespace scanway::schunk::request
