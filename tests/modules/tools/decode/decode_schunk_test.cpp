#include "modules/tools/decode/decode_schunk.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace scanway {
namespace {

using Json = nlohmann::json;

std::vector<Json> decode(const std::string& text) {
  std::ostringstream out;
  tools::decode_schunk(text, out);
  std::vector<Json> lines;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

/// What a line must hold, besides its offset.
void expect_parts(const Json& line, const Json& parts) {
  for (const auto& [key, value] : parts.items()) {
    ASSERT_TRUE(line.contains(key)) << key << " in " << line;
    if (value.is_number_float()) {
      EXPECT_NEAR(line[key].get<double>(), value.get<double>(), 5e-4 * std::max(1.0, std::abs(value.get<double>())))
          << line;
    } else {
      EXPECT_EQ(line[key], value) << line;
    }
  }
}

/// What each vector of the protocol sheet says, by its id; fragments under their last one.
const std::map<std::string, Json>& meanings() {
  static const std::map<std::string, Json> table = {
      {"get_state_cyclic_1s_pos",
       {{"type", "GET STATE"}, {"kind", "request"}, {"period_s", 1.0}, {"mask", {"position"}}}},
      {"state_pos_moving", {{"position", 1.012}, {"state", {"moving"}}, {"error", nullptr}, {"module", 1}}},
      {"state_pos_moving_2", {{"position", 5.0545}, {"state", {"moving"}}}},
      {"error_motor_voltage_low", {{"type", "CMD ERROR"}, {"code", "74"}, {"name", "MOTOR VOLTAGE LOW"}}},
      {"ack_req", {{"type", "CMD ACK"}, {"kind", "request"}}},
      {"ack_ok", {{"type", "CMD ACK"}, {"kind", "answer"}, {"ok", true}}},
      {"info_no_error", {{"type", "CMD INFO"}, {"code", "08"}, {"name", "NO ERROR"}, {"kind", "impulse"}}},
      {"reference_req", {{"type", "CMD REFERENCE"}, {"kind", "request"}}},
      {"reference_ok", {{"type", "CMD REFERENCE"}, {"ok", true}}},
      {"reference_done_blocked", {{"type", "CMD MOVE BLOCKED"}, {"position", 5.792}}},
      {"move_pos_10", {{"type", "MOVE POS"}, {"kind", "request"}, {"position", 10.0}}},
      {"move_pos_10_eta", {{"type", "MOVE POS"}, {"kind", "answer"}, {"seconds", 3.358}}},
      {"pos_reached", {{"type", "CMD POS REACHED"}, {"position", 9.997}}},
      {"move_pos_10_eta_83", {{"seconds", 8.3}}},
      {"move_vel_111", {{"type", "MOVE VEL"}, {"velocity", 11.1}}},
      {"move_vel_ok", {{"type", "MOVE VEL"}, {"ok", true}}},
      {"stop_req", {{"type", "CMD STOP"}, {"kind", "request"}}},
      {"stop_ok", {{"type", "CMD STOP"}, {"ok", true}}},
      {"fast_stop_req", {{"type", "CMD FAST STOP"}}},
      {"fast_stop_error", {{"type", "CMD ERROR"}, {"name", "FAST STOP"}}},
      {"set_target_vel_122", {{"type", "SET TARGET VEL"}, {"velocity", 12.2}}},
      {"set_target_vel_ok", {{"type", "SET TARGET VEL"}, {"ok", true}}},
      {"move_blocked_123", {{"position", 1.23}}},
      {"pos_reached_27", {{"position", 2.7}}},
      {"error_tow", {{"type", "CMD ERROR"}, {"code", "DA"}, {"name", "TOW"}}},
      {"warning_soft_high", {{"type", "CMD WARNING"}, {"code", "D6"}, {"name", "SOFT HIGH"}}},
      {"detailed_error_req", {{"type", "GET DETAILED ERROR INFO"}, {"kind", "request"}}},
      {"detailed_error_ans", {{"class", "CMD ERROR"}, {"code", "D9"}, {"data", 0.0}}},
      {"set_target_acc_req", {{"type", "SET TARGET ACC"}, {"acceleration", 12.2}}},
      {"set_target_acc_ok", {{"type", "SET TARGET ACC"}, {"ok", true}}},
      {"set_target_jerk_req", {{"type", "SET TARGET JERK"}, {"jerk", 1000.0}}},
      {"set_target_jerk_ok", {{"type", "SET TARGET JERK"}, {"ok", true}}},
      {"set_target_cur_req", {{"type", "SET TARGET CUR"}, {"current_A", 2.7}}},
      {"set_target_cur_ok", {{"type", "SET TARGET CUR"}, {"ok", true}}},
      {"set_target_time_req", {{"type", "SET TARGET TIME"}, {"seconds", 4.7}}},
      {"set_target_time_ok", {{"type", "SET TARGET TIME"}, {"ok", true}}},
      {"move_pos_rel_10", {{"type", "MOVE POS REL"}, {"position", 10.0}}},
      {"move_pos_rel_eta", {{"type", "MOVE POS REL"}, {"seconds", 8.3}}},
      {"get_state_once_pos", {{"period_s", 0.0}, {"mask", {"position"}}}},
      {"state_not_referenced", {{"position", 0.0}, {"state", {"brake_applied"}}}},
      {"state_pos_reached", {{"position", 0.0}, {"state", {"position_reached"}}}},
      {"get_config_unit", {{"type", "GET CONFIG"}, {"setting", "unit_system"}}},
      {"get_config_unit_ans", {{"setting", "unit_system"}, {"value", 0}, {"name", "mm"}}},
      {"set_config_id", {{"type", "SET CONFIG"}, {"setting", "module_id"}, {"value", 12}}},
      {"set_config_id_ok", {{"type", "SET CONFIG"}, {"kind", "answer"}, {"setting", "module_id"}}},
      {"toggle_impulse_req", {{"type", "CMD TOGGLE IMPULSE MESSAGE"}, {"kind", "request"}}},
      {"toggle_impulse_on", {{"impulses", true}}},
      {"toggle_impulse_off", {{"impulses", false}}},
      {"reboot_req", {{"type", "CMD REBOOT"}, {"kind", "request"}}},
      {"reboot_ok", {{"type", "CMD REBOOT"}, {"ok", true}}},
      {"info_boot", {{"type", "CMD INFO"}, {"name", "BOOT"}}},
      {"egl_ack", {{"type", "CMD ACK"}, {"module", 12}}},
      {"egl_reference", {{"type", "CMD REFERENCE"}, {"module", 12}}},
      {"egl_vel30", {{"type", "MOVE VEL"}, {"velocity", 30.0}}},
      {"egl_vel_m30", {{"type", "MOVE VEL"}, {"velocity", -30.0}}},
      {"egl_vel30_cur1_f2", {{"type", "MOVE VEL"}, {"velocity", 30.0}, {"current_A", 1.0}}},
      {"egl_vel30_cur1_3f_3", {{"type", "MOVE VEL"}, {"velocity", 30.0}, {"current_A", 1.0}}},
      {"state_full_f3",
       {{"position", 15.04}, {"velocity", 3.028}, {"current_A", 0.4595}, {"state", {"referenced", "moving"}}}},
      {"state_full_estop_f3",
       {{"position", 22.9235},
        {"velocity", 0.0},
        {"state", {"referenced", "brake_applied", "move_end"}},
        {"error", "D9 FAST STOP"}}},
      {"state_posvel_f2", {{"position", 45.5}, {"velocity", -12.25}, {"module", 11}, {"error", nullptr}}},
      {"get_state_100hz", {{"period_s", 0.01}, {"mask", {"position", "velocity"}}}},
      {"get_state_stop", {{"period_s", 0.0}, {"mask", Json::array()}}},
      {"pan_move_90", {{"type", "MOVE POS"}, {"position", 90.0}, {"module", 11}}},
      {"tilt_move_m30rad", {{"type", "MOVE POS"}, {"position", -0.523599}, {"module", 12}}},
      {"set_target_vel_30", {{"velocity", 30.0}, {"module", 11}}},
      {"move_refused", {{"type", "MOVE POS"}, {"kind", "failure"}, {"name", "FAILED"}}},
      {"move_refused_wrong_param", {{"kind", "failure"}, {"name", "WRONG PARAMETER"}}},
      {"unknown_command", {{"kind", "failure"}, {"name", "UNKNOWN COMMAND"}}},
      {"pc_get_pos", {{"type", "PowerCube GET PARAMETER"}, {"kind", "request"}, {"parameter", "position_rad"}}},
      {"pc_get_pos_ans", {{"kind", "answer"}, {"value", 0.5}, {"module", 11}}},
      {"pc_move_ramp", {{"type", "PowerCube SET MOVE"}, {"parameter", "ramp"}, {"value", 1.0}}},
  };
  return table;
}

struct Row {
  std::string id, line;
};

std::vector<Row> read_vectors(const std::string& path) {
  std::istringstream in(test::read_text(path));
  std::vector<Row> rows;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::string id, skipped, frame;
    std::getline(cells, id, ',');
    for (int i = 0; i < 3; ++i) std::getline(cells, skipped, ',');
    std::getline(cells, frame, ',');
    rows.push_back({id, frame});
  }
  return rows;
}

TEST(DecodeSchunk, GivesEveryVectorOfTheSheetItsMeaning) {
  const std::string path = SCANWAY_SHARED_DIR "/facts/schunk/smp_can_vectors.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "the shared facts are not here: " << path;
  const std::vector<Row> rows = read_vectors(path);
  EXPECT_EQ(rows.size(), 78u);
  std::string pending, first_of_three;
  std::size_t meant = 0;
  for (const Row& row : rows) {
    if (row.id == "egl_vel30_cur1_f1") first_of_three = row.line + "\n";
    if (row.id == "egl_vel30_cur1_3f_2") pending = first_of_three;  // The sheet lists the common first frame once.
    pending += row.line + "\n";
    const auto meaning = meanings().find(row.id);
    if (meaning == meanings().end()) continue;  // A fragment that is not the last.
    ++meant;
    const std::vector<Json> lines = decode(pending);
    ASSERT_EQ(lines.size(), 1u) << row.id;
    expect_parts(lines[0], meaning->second);
    pending.clear();
  }
  EXPECT_EQ(meant, meanings().size());
  EXPECT_TRUE(pending.empty());
}

TEST(DecodeSchunk, ReadsTheSheetsTableItself) {
  const std::string path = SCANWAY_SHARED_DIR "/facts/schunk/smp_can_vectors.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "the shared facts are not here: " << path;
  const std::vector<Json> lines = decode(test::read_text(path));
  // 78 frames, of which 1 + 2 + 2 + 1 are fragments that are not the last; the two of another form have no first one.
  EXPECT_EQ(lines.size(), 72u);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const Json& line) { return line["type"] == "bad"; }), 2);
}

TEST(DecodeSchunk, ReadsEveryFormOfCandump) {
  for (const char* line :
       {"(1436509052.249713) can0 70B#05B600002041", "70B#05.B6.00.00.20.41",
        " (1436509052.249713)  can0  70B   [6]  05 B6 00 00 20 41", "  vcan0  70B   [6]  05 B6 00 00 20 41",
        "(1436509052.249713) can0 70B#05B600002041 R\r", "  can0  RX - -  70B   [6]  05 B6 00 00 20 41   '.... A'"}) {
    const std::vector<Json> lines = decode(line);
    ASSERT_EQ(lines.size(), 1u) << line;
    expect_parts(lines[0], {{"type", "unknown command B6"}, {"bytes", "00 00 20 41"}, {"module", 11}});
    if (std::string(line).find('(') != std::string::npos) {
      EXPECT_EQ(lines[0]["utime"], 1436509052249713);
    }
  }
}

TEST(DecodeSchunk, TakesOverTheUnitThatTheModuleNames) {
  // Milli-degrees: integers.
  const auto lines = decode("50B#028006\n70B#03800609\n50B#0695E803000001\n70B#0795905F01000300\n");
  ASSERT_EQ(lines.size(), 4u);
  expect_parts(lines[1], {{"name", "mdeg int"}});
  expect_parts(lines[2], {{"period_s", 1.0}});
  expect_parts(lines[3], {{"position", 90000.0}, {"unit", "mdeg int"}});
}

TEST(DecodeSchunk, NamesWhatOnlyTheMaskTells) {
  const auto lines = decode("50B#06950000000004\n70B#07950000803F0300\n");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_FALSE(lines[1].contains("position"));
  expect_parts(lines[1], {{"current_A", 1.0}});
}

TEST(DecodeSchunk, MarksWhatIsBrokenByLine) {
  const std::string good = "70B#038B4F4B\n";
  const auto lines = decode(good + "this is noise\n" + "70B#078B4F\n" + "20000040#0000000000000000\n" + "123#R\n" +
                            "12345678#01\n" + "70B#0B84950000364200\n" + good);
  ASSERT_EQ(lines.size(), 8u);
  EXPECT_EQ(lines[1], (Json{{"type", "bad"}, {"offset", 13}, {"length", 13}, {"reason", lines[1]["reason"]}}));
  EXPECT_EQ(lines[2]["type"], "bad");
  EXPECT_NE(lines[2]["reason"].get<std::string>().find("D-Len says 7 bytes"), std::string::npos);
  EXPECT_EQ(lines[3]["errors"], "bus off");
  EXPECT_EQ(lines[4]["type"], "remote frame");
  EXPECT_EQ(lines[5]["type"], "extended frame");
  EXPECT_EQ(lines[6]["type"], "CMD ACK");  // Between the fragment and the end of the recording.
  EXPECT_EQ(lines[7]["type"], "bad");
  EXPECT_EQ(lines[7]["length"], 20);
}

TEST(DecodeSchunk, PutsInterleavedFragmentsTogether) {
  const auto lines = decode("70B#0B84950000364200\n70C#0B84950000364200\n70C#05860044C10300\n70B#05860044C10300\n");
  ASSERT_EQ(lines.size(), 2u);
  expect_parts(lines[0], {{"module", 12}, {"position", 45.5}, {"velocity", -12.25}});
  expect_parts(lines[1], {{"module", 11}, {"position", 45.5}, {"velocity", -12.25}});
}

}  // namespace
}  // namespace scanway
