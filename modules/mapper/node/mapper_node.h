#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "common/bus/bus.h"
#include "common/bus/ordered_merge.h"
#include "common/cloud/sweep.h"
#include "common/messages/object_input.h"
#include "common/messages/objects.h"
#include "common/progress/stages.h"
#include "modules/mapper/core/mapper.h"
#include "modules/mapper/node/map_commands.h"
#include "modules/mapper/node/map_publisher.h"
#include "modules/mapper/node/placement_tally.h"
#include "modules/mapper/node/sweep_assembler.h"
#include "modules/mapper/node/sweep_store.h"
#include "scanway/map_state_t.hpp"
#include "scanway/sweep_inputs_t.hpp"

namespace scanway {

/// An orientation that is older than this when the sweep ends says nothing of it any more.
constexpr Utime kMaxOrientationAge = 2 * kMicrosecondsPerSecond;

/// Of sweeps that were worked on before: by a sweep's digest, that of the IMU message whose orientation it used, if
/// any.
using ListedOrientations = std::map<std::uint64_t, std::optional<std::uint64_t>>;

/// The mapper on the bus: SWEEP and IMU in, merged by their own time; SWEEP_INPUTS, REGISTRATION, POSE and the map's
/// products out. MAP_COMMAND in, MAP_ANSWER out.
class MapperNode {
 public:
  /// `bus` and `stages` must outlive this.
  MapperNode(Bus& bus, const Robot& robot, StageListener* stages = nullptr);

  /// No more input will come: what still waits for data with a later time is worked on now.
  void finish();

  /// A sweep that `listed` names gets the orientation that is named there, whatever came when. For replay.
  void use(ListedOrientations listed) { listed_ = std::move(listed); }
  /// Commands that were answered so are carried out where they were then, whenever they come. For replay.
  void use(std::vector<map_answer_t> answers) { commands_.use(std::move(answers)); }
  /// A sweep that was assembled here, before its pieces come: it has the orientation of its own time, and SWEEP_INPUTS
  /// says what it was made of. However long its pieces take, it does not come too late.
  void expect(SweepOrigin origin);
  /// `finished` is told of each sweep, by its name and time, when all of its products are published.
  void on_finished(std::function<void(std::string_view, Utime)> finished) { finished_ = std::move(finished); }
  /// `save` saves the map under a name when a command asks for it, or throws InputError. Without it (in replay) such
  /// commands are not answered.
  void on_save(std::function<void(const std::string& name)> save) { save_ = std::move(save); }

  /// Works on the sweeps that `store` holds, and on the map that it continues, and keeps those that come in it from now
  /// on. It must outlive this.
  void restore(const SweepStore& store);
  /// Keeps the sweeps that come in `store`, which is empty. It must outlive this.
  void keep_in(const SweepStore& store) { store_ = &store; }
  /// Goes on with a map of another session: of all that is made of its sweeps, only the whole map is published, as the
  /// first version. What comes from now on is searched in it. Before any other input.
  void resume(const SweepStore& map);
  /// Nothing has come for a while, so nothing with an earlier time is on its way: what waits is worked on. What it was
  /// made of is in SWEEP_INPUTS, as ever. Unless pieces of sweeps are still expected (asked for), sweeps that are not
  /// whole are given up and counted, so that the map is settled without them.
  void settle(bool sweeps_expected = false);
  /// How far the map is (MAP_STATE).
  map_state_t state() const;
  std::size_t news() const { return news_; }  ///< Inputs taken so far.
  std::string summary() const;                ///< What people should know, in one line; empty: nothing.

  const Mapper& mapper() const { return mapper_; }
  const MapPublisher& published() const { return publisher_; }
  /// What was bad, late or incomplete so far, by name.
  std::map<std::string, std::int64_t> counters() const;

 private:
  struct Orientation {
    Utime utime = 0;
    Eigen::Quaterniond R_world_sweep;
    std::vector<std::uint8_t> message;
  };
  struct ArrivedSweep {
    Sweep sweep;
    Object object;  ///< Its bytes only if they are to be kept.
  };
  using Input = std::variant<Orientation, ArrivedSweep>;

  OrderedMerge<Input> merge();
  void take_imu(const BusMessage& message);
  bool is_listed(std::uint64_t imu) const;
  std::optional<Orientation> orientation_for(const ArrivedSweep& arrived) const;
  void take_piece(const BusMessage& message);
  void work_on(Input&& input);
  void add_sweep(ArrivedSweep&& arrived);
  sweep_inputs_t inputs_of(const ArrivedSweep& arrived) const;
  input_span_t imu_span() const;
  void publish_result(const SweepResult& result, const Sweep& sweep);
  void keep(const Object& sweep, const std::optional<Orientation>& orientation);
  void take_command(const BusMessage& message);
  void carry_out_due();
  void carry_out(const map_command_t& command);
  void withdraw(const map_command_t& command);
  void save(const map_command_t& command);
  void answer(const map_command_t& command, std::uint64_t version, const std::string& refusal);
  void keep(const map_command_t& command);
  void work_on_session(const SweepStore& map);
  void work_on_kept(const std::string& log);
  void begin_session();
  void take_origin(const BusMessage& message);
  void release_held();

  Bus& bus_;
  StageListener* stages_;
  Mapper mapper_;
  MapPublisher publisher_;
  PlacementTally placements_;
  ObjectInput<Sweep> sweeps_;
  OrderedMerge<Input> inputs_;
  std::optional<Orientation> newest_orientation_;  // That the merge let go.
  std::optional<Orientation> orientation_;         // Of the sweep that is worked on.
  std::map<std::uint64_t, SweepOrigin> origins_;   // By the sweep's digest.
  std::set<std::uint64_t> awaited_;                // Of these, whose pieces are on their way.
  std::set<std::uint64_t> arrived_;                // Digests of all sweeps that came.
  std::vector<Orientation> held_;                  // That came since then.
  int silences_ = 0;                               // In a row, with sweeps awaited.
  MapCommands commands_;
  std::uint64_t last_sweep_ = 0;  // Digest of the one that was worked on last.
  ListedOrientations listed_;
  std::map<std::uint64_t, Orientation> listed_arrived_;  // By the digest of the message.
  std::function<void(std::string_view, Utime)> finished_;
  std::function<void(const std::string&)> save_;
  const SweepStore* store_ = nullptr;
  std::string store_trouble_;
  bool silent_ = false;  // At work on the sweeps of another session.
  std::int64_t waiting_sweeps_ = 0;
  std::size_t news_ = 0;
  Utime map_utime_ = 0;  // Of the newest sweep in the map.
  std::int64_t settled_in_silence_ = 0;
  std::int64_t without_orientation_ = 0;
  std::int64_t bad_messages_ = 0;
};

}  // namespace scanway
