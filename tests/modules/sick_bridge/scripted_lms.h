#pragma once

#include <deque>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/modules/sick_bridge/shared_lms.h"

namespace scanway::test {

/// Answers as the LMS511 of the recorded dialogue did: each recorded request with its recorded bytes, requests that
/// were not recorded with the recorded sFA 3, and after the subscription the recorded scans, or what it is given.
class ScriptedLms {
 public:
  explicit ScriptedLms(const std::string& scans = {}) {
    std::istringstream lines(read_text(kLmsData + "lms511_colab_session_20210302.jsonl"));
    std::string line, request;
    while (std::getline(lines, line)) {
      const auto said = nlohmann::json::parse(line);
      const auto bytes = bytes_of_hex(said["hex"]);
      const std::string frame(bytes.begin(), bytes.end());
      if (said["dir"] == "host->sensor") {
        request = frame;
      } else if (said["ascii"].get<std::string>().starts_with("sSN")) {
        scans_.push_back(frame);
      } else {
        answers_[request] = frame;
      }
    }
    if (!scans.empty()) scans_ = {scans};
  }

  /// What the device sends when it gets these bytes.
  std::string answer(const std::string& bytes) {
    finder_.push(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
    std::string out;
    while (const auto stretch = finder_.next()) {
      if (stretch->whole) out += answer_one({stretch->bytes.begin(), stretch->bytes.end()});
    }
    return out;
  }

  int unknown_requests() const { return unknown_requests_; }
  /// sSN telegrams of the recording, the scans among them.
  const std::vector<std::string>& scans() const { return scans_; }

 private:
  std::string answer_one(const std::string& request) {
    const auto known = answers_.find(request);
    if (known == answers_.end()) {
      ++unknown_requests_;
      return std::string("\2\2\2\2\0\0\0\5sFA\0\3\x77", 14);
    }
    std::string out = known->second;
    if (request.find("sEN LMDscandata") == std::string::npos) return out;
    for (const std::string& scan : scans_) out += scan;
    return out;
  }

  FrameFinder finder_ = sick::make_frame_finder();
  std::map<std::string, std::string> answers_;
  std::vector<std::string> scans_;
  int unknown_requests_ = 0;
};

}  // namespace scanway::test
