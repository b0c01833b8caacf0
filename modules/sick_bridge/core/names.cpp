#include "modules/sick_bridge/core/names.h"

#include <span>

#include "modules/sick_bridge/core/scan.h"

namespace scanway::sick {
namespace {

// SICK's telegram listing 8014631, sFA. 26 is printed as hexadecimal 20 there, which 32 covers.
constexpr const char* kErrors[] = {
    "ok",
    "access denied (wrong user level)",
    "unknown method",
    "unknown variable",
    "local condition failed (a value is out of range)",
    "invalid data",
    "unknown error",
    "buffer overflow (too many parameters)",
    "buffer underflow (too few parameters)",
    "unknown type",
    "write denied (read-only)",
    "unknown command for the name server",
    "unknown CoLa command",
    "server busy",
    "array index out of bounds",
    "unknown event",
    "CoLa-A value overflow",
    "CoLa-A invalid character",
    "no message from the operating system",
    "no answer from the operating system",
    "internal error",
    "hub address corrupted",
    "hub address not decoded",
    "hub address exceeded",
    "hub address: blank expected",
    "asynchronous methods suppressed",
    "complex arrays not supported",
};
constexpr const char* kDeviceStates[] = {"busy", "ready", "error", "standby"};
constexpr const char* kContaminations[] = {"none", "warning", "error", "defective"};
constexpr const char* kStatuses[] = {"booting", "booting",   "booting",         "booting", "booting", "booting",
                                     "ready",   "measuring", "firmware update", nullptr,   "error"};
constexpr const char* kScanConfigErrors[] = {"", "frequency", "resolution", "resolution and scan area", "scan area"};

std::string look_up(std::span<const char* const> names, unsigned number, const char* unknown) {
  if (number < names.size() && names[number] != nullptr) return names[number];
  return unknown + std::to_string(number);
}

}  // namespace

std::string error_name(unsigned code) {
  if (code == 32) return kErrors[26];
  return look_up(kErrors, code, "unlisted error ");
}

std::string device_state_name(unsigned state) { return look_up(kDeviceStates, state, "unlisted state "); }

std::string contamination_name(unsigned state) { return look_up(kContaminations, state, "unlisted state "); }

std::string operating_status_name(unsigned status) { return look_up(kStatuses, status, "unlisted status "); }

std::string scan_config_error(unsigned status) { return look_up(kScanConfigErrors, status, "unlisted reason "); }

std::string device_status_text(std::uint16_t status) {
  std::string text;
  const auto add = [&](const std::string& word) { text += (text.empty() ? "" : ", ") + word; };
  if ((status & kDeviceError) != 0) add("error");
  if ((status & kPollutionWarning) != 0) add("pollution warning");
  if ((status & kPollutionError) != 0) add("pollution error");
  if ((status & ~7U) != 0) add("unlisted bits " + std::to_string(status & ~7U));
  return text;
}

}  // namespace scanway::sick
