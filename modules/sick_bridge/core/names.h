#pragma once

#include <cstdint>
#include <string>

/// The device's numbers in words.
namespace scanway::sick {

/// Of an sFA answer: "unknown variable"; "unlisted error 99" for codes that no sheet lists.
std::string error_name(unsigned code);

/// Of SCdevicestate: "ready".
std::string device_state_name(unsigned state);

/// Of LCMstate, dirt on the front window: "none", "warning", "error", "defective".
std::string contamination_name(unsigned state);

/// Of the status of STlms: "measuring".
std::string operating_status_name(unsigned status);

/// Of the status of mLMPsetscancfg: what the device does not accept; empty for 0, all well.
std::string scan_config_error(unsigned status);

/// The bits of Scan::device_status: "error, pollution warning"; empty for 0, all well.
std::string device_status_text(std::uint16_t status);

}  // namespace scanway::sick
