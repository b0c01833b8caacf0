#include <functional>
#include <map>
#include <sstream>

#include "modules/sick_bridge/core/commands.h"
#include "modules/sick_bridge/core/describe.h"
#include "tests/modules/sick_bridge/shared_lms.h"

namespace scanway::test {
namespace {

using sick::Dialect;

struct Vector {
  std::string id;
  Dialect dialect = Dialect::cola_a;
  bool from_host = false;
  std::string hex;
};

/// The first four columns, which never hold a comma.
std::vector<Vector> command_vectors() {
  std::istringstream lines(read_text(kLmsData + "command_vectors.csv"));
  std::string line;
  std::getline(lines, line);
  std::vector<Vector> vectors;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string id, dialect, direction, hex;
    std::getline(fields, id, ','), std::getline(fields, dialect, ','), std::getline(fields, direction, ',');
    std::getline(fields, hex, ',');
    vectors.push_back({id, dialect == "CoLa-B" ? Dialect::cola_b : Dialect::cola_a, direction == "host->sensor", hex});
  }
  return vectors;
}

std::string hex_of(const std::string& bytes) {
  std::string hex;
  for (const char byte : bytes) {
    constexpr char kDigits[] = "0123456789abcdef";
    hex += kDigits[static_cast<std::uint8_t>(byte) >> 4];
    hex += kDigits[byte & 0xF];
  }
  return hex;
}

sick::ScanContent content(std::uint16_t channels, bool rssi, std::uint16_t encoders, bool date) {
  sick::ScanContent wanted;
  wanted.channels = channels;
  wanted.rssi = rssi;
  wanted.encoders = encoders;
  wanted.date = date;
  return wanted;
}

sick::ScanContent printed_encoder_example() {
  sick::ScanContent wanted = content(2, false, 1, false);
  wanted.rssi_16_bit = true;
  wanted.every = 0x4A;
  return wanted;
}

using Make = std::function<sick::Request(Dialect)>;

Make read(const char* name) {
  return [=](Dialect dialect) { return sick::read_variable(dialect, name); };
}
Make call(const char* name) {
  return [=](Dialect dialect) { return sick::call_method(dialect, name); };
}
template <class Function, class... Arguments>
Make make(Function function, Arguments... arguments) {
  return [=](Dialect dialect) { return function(dialect, arguments...); };
}

/// How each request of the table is made.
std::map<std::string, Make> makers() {
  using namespace sick;
  return {{"login_req", make(log_in)},
          {"cola_b_req", make(set_host_dialect, Dialect::cola_b)},
          {"fw_req", read("FirmwareVersion")},
          {"devstate_req", read("SCdevicestate")},
          {"oprh_req", read("ODoprh")},
          {"pwrc_req", read("ODpwrc")},
          {"name_req", read("LocationName")},
          {"range_read_req", read("LMPoutputRange")},
          {"range_write_req", make(set_output_range, ScanConfig{})},
          {"range_write_0_180_req", make(set_output_range, ScanConfig{2500, 1667, 0, 1800000})},
          {"scandatacfg_write_req", make(set_scan_content, content(1, true, 0, true))},
          {"scandatacfg_enc_req", make(set_scan_content, printed_encoder_example())},
          {"scandatacfg_rssi_time_req", make(set_scan_content, content(0, true, 0, true))},
          {"scandatacfg_rssi_time_enc_req", make(set_scan_content, content(0, true, 1, true))},
          {"scandatacfg_read_req", read("LMDscandatacfg")},
          {"startmeas_req", call("LMCstartmeas")},
          {"lmcstartmeas_req", call("LMCstartmeas")},
          {"lmcstopmeas_req", call("LMCstopmeas")},
          {"meewriteall_req", call("mEEwriteall")},
          {"run_req", call("Run")},
          {"scan_on_req", make(subscribe, "LMDscandata", true)},
          {"scan_off_req", make(subscribe, "LMDscandata", false)},
          {"setscancfg_lms1xx_req", make(set_scan_config, ScanConfig{5000, 5000, -450000, 2250000})},
          {"setscancfg_25hz_01667_req", make(set_scan_config, ScanConfig{})},
          {"poll_req", read("LMDscandata")},
          {"encres_req", make(set_encoder_resolution, 1000.0F)},
          {"setdatetime_req", make(set_date, DeviceDate{2010, 1, 26, 10, 35, 0, 0})},
          {"echofilter_0_req", make(set_echo_filter, EchoFilter::first)},
          {"echofilter_1_req", make(set_echo_filter, EchoFilter::all)},
          {"echofilter_2_req", make(set_echo_filter, EchoFilter::last)},
          {"stlms_req", read("STlms")},
          {"encset_off", make(set_encoder_setting, std::uint8_t{0})},
          {"encset_1", make(set_encoder_setting, std::uint8_t{1})},
          {"encsrc_enc", make(set_encoder_source, true)}};
}

TEST(CommandVectors, EveryRequestIsMadeToTheByte) {
  SKIP_WITHOUT_LMS_DATA();
  const auto known = makers();
  int compared = 0;
  for (const Vector& vector : command_vectors()) {
    // The same request in the table's other notation; it is read below.
    if (!vector.from_host || vector.id == "setscancfg_25hz_01667_req_hex") continue;
    ASSERT_TRUE(known.contains(vector.id)) << vector.id;
    EXPECT_EQ(hex_of(known.at(vector.id)(vector.dialect).frame), vector.hex) << vector.id;
    ++compared;
  }
  EXPECT_EQ(compared, 47);
}

sick::Fields described(const std::string& id, Dialect dialect) {
  for (const Vector& vector : command_vectors()) {
    if (vector.id == id && vector.dialect == dialect) return describe(telegrams_in(bytes_of_hex(vector.hex)).at(0));
  }
  ADD_FAILURE() << "no vector " << id;
  return {};
}

TEST(CommandVectors, EveryFrameIsReadInItsDialect) {
  SKIP_WITHOUT_LMS_DATA();
  for (const Vector& vector : command_vectors()) {
    const auto telegrams = telegrams_in(bytes_of_hex(vector.hex));
    ASSERT_EQ(telegrams.size(), 1U) << vector.id;
    EXPECT_EQ(telegrams[0].dialect, vector.dialect) << vector.id;
    EXPECT_NO_THROW(describe(telegrams[0])) << vector.id;
  }
}

TEST(CommandVectors, AnswersAreReadInBothDialects) {
  SKIP_WITHOUT_LMS_DATA();
  using sick::Fields;
  const Fields mode{{"frequency_centihz", 2500},
                    {"areas", 1},
                    {"resolution_1e4_deg", 1667},
                    {"start_angle_1e4_deg", -50000},
                    {"stop_angle_1e4_deg", 1850000}};
  EXPECT_EQ(described("setscancfg_25hz_01667_req", Dialect::cola_b), mode);
  EXPECT_EQ(described("setscancfg_25hz_01667_req", Dialect::cola_a), mode);
  EXPECT_EQ(described("setscancfg_25hz_01667_req_hex", Dialect::cola_a), mode);
  EXPECT_EQ(described("fw_ans", Dialect::cola_b), (Fields{{"text", "V1.80    "}}));
  EXPECT_EQ(described("name_ans", Dialect::cola_b), (Fields{{"text", "SN 18110550"}}));
  EXPECT_EQ(described("oprh_ans", Dialect::cola_b), (Fields{{"tenths_of_an_hour", 1195}}));
  EXPECT_EQ(described("pwrc_ans", Dialect::cola_b), (Fields{{"count", 99}}));
  EXPECT_EQ(described("devstate_ans", Dialect::cola_b), (Fields{{"state", 0}, {"state_name", "busy"}}));
  EXPECT_EQ(described("deviceident_ans", Dialect::cola_b),
            (Fields{{"model", "LMS10x_FieldEval"}, {"version", "V1.36-21.10.2010"}}));
  EXPECT_EQ(described("stlms_ans", Dialect::cola_a)[1].second, sick::FieldValue("measuring"));
  EXPECT_EQ(described("setscancfg_25hz_01667_badres", Dialect::cola_b)[1].second, sick::FieldValue("resolution"));
  EXPECT_EQ(described("login_fail", Dialect::cola_a), (Fields{{"accepted", 0}}));
}

TEST(CommandVectors, ErrorsHaveTheirNames) {
  SKIP_WITHOUT_LMS_DATA();
  const sick::Fields one{{"code", 1}, {"error", "access denied (wrong user level)"}};
  EXPECT_EQ(described("sfa_1", Dialect::cola_a), one);
  EXPECT_EQ(described("sfa_1", Dialect::cola_b), one);
  EXPECT_EQ(described("sfa_1_listing_form", Dialect::cola_b), one);
  EXPECT_EQ(described("sfa_3", Dialect::cola_b), (sick::Fields{{"code", 3}, {"error", "unknown variable"}}));
}

TEST(CommandVectors, RecordedDialoguesAreReadWhole) {
  SKIP_WITHOUT_LMS_DATA();
  for (const char* name : {"lms511_colab_session_20210301_sfa.jsonl", "lms511_colab_session_20210302.jsonl"}) {
    std::istringstream lines(read_text(kLmsData + name));
    std::string line;
    while (std::getline(lines, line)) {
      const auto said = nlohmann::json::parse(line);
      const auto telegrams = telegrams_in(bytes_of_hex(said["hex"]));
      ASSERT_EQ(telegrams.size(), 1U) << said["ascii"];
      const sick::Telegram& telegram = telegrams[0];
      EXPECT_EQ(said["ascii"].get<std::string>().substr(0, 3), telegram.command);
      if (is_scan(telegram)) {
        EXPECT_EQ(parse_scan(telegram).channels_16_bit.at(0).counts.size(), 1141U);
      } else {
        EXPECT_NO_THROW(describe(telegram));
      }
    }
  }
}

}  // namespace
}  // namespace scanway::test
