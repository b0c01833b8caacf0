#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "modules/sick_bridge/core/cola.h"
#include "tests/modules/sick_bridge/hostile_lms.h"

namespace scanway::test {

/// A device of few words: it says yes to everything, in one dialect.
class YesMan {
 public:
  explicit YesMan(sick::Dialect dialect) : dialect_(dialect) {}

  std::string answer(const std::string& bytes) {
    finder_.push(bytes_of(bytes));
    std::string out;
    while (const auto stretch = finder_.next()) {
      if (!stretch->whole) continue;
      const sick::Telegram request = sick::open_frame(stretch->bytes);
      if (request.dialect != dialect_) continue;
      asked.push_back(request.command + ' ' + request.name);
      out += sick::make_frame(dialect_, reply(request));
    }
    return out;
  }

  std::vector<std::string> asked;
  std::string scan_config_status = "0";
  std::string login = "1";
  std::string model;  ///< Empty: it does not say.
  std::string read_back = "9C4 1 683 FFFF3CB0 1C3A90";

 private:
  std::string reply(const sick::Telegram& request) const {
    const std::string& name = request.name;
    if (request.command == "sEN") return "sEA " + name + ' ' + value("1");
    if (request.command == "sWN") return "sWA " + name + (dialect_ == sick::Dialect::cola_b ? " " : "");
    if (request.command == "sMN") {
      const bool zero_is_success = name == "LMCstartmeas";
      if (name == "mLMPsetscancfg") return "sAN mLMPsetscancfg " + value(scan_config_status);
      if (name == "SetAccessMode") return "sAN SetAccessMode " + value(login);
      return "sAN " + name + ' ' + value(zero_is_success ? "0" : "1");
    }
    if (name == "LMPscancfg" && dialect_ == sick::Dialect::cola_a) return "sRA LMPscancfg " + read_back;
    if (name == "DeviceIdent" && !model.empty()) return "sRA DeviceIdent " + text(model) + between() + text("V1.0");
    if (name == "SCdevicestate" || name == "LCMstate") return "sRA " + name + ' ' + value("1");
    return dialect_ == sick::Dialect::cola_a ? "sFA 3" : std::string("sFA\0\3", 5);
  }

  std::string between() const { return dialect_ == sick::Dialect::cola_a ? " " : ""; }

  std::string text(const std::string& characters) const {
    if (dialect_ == sick::Dialect::cola_b) return std::string{'\0', static_cast<char>(characters.size())} + characters;
    std::ostringstream hex;
    hex << std::hex << std::uppercase << characters.size() << ' ' << characters;
    return hex.str();
  }

  std::string value(const std::string& digit) const {
    return dialect_ == sick::Dialect::cola_a ? digit : std::string(1, static_cast<char>(digit[0] - '0'));
  }

  sick::Dialect dialect_;
  FrameFinder finder_ = sick::make_frame_finder();
};

}  // namespace scanway::test
