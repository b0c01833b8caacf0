#include "modules/simulator/device/lms/mirror.h"

#include <cmath>

#include "common/random/random.h"

namespace scanway::simulator {
namespace {

constexpr Utime kAfterLastBeam = 18'900;  // Recorded scans are sent 40.2 to 41.0 ms after their first beam.
constexpr double kJitter_us = 80.0;       // Recorded scans come every 39.7 to 40.4 ms.
constexpr double kField_deg = 190.0;

}  // namespace

MirrorTurn Mirror::turn(std::int64_t number) const {
  MirrorTurn turn;
  turn.number = number;
  turn.start = start_of(number);
  turn.sector = sector_of(mode_, sector_start_, sector_stop_, number);
  turn.step_deg = mode_.step_deg();
  turn.beam_period_us = mode_.period_us() * turn.step_deg / 360.0;
  return turn;
}

Utime Mirror::start_of(std::int64_t number) const {
  Random random(static_cast<std::uint64_t>(number) * 0x9E3779B97F4A7C15U);
  return std::llround(static_cast<double>(number) * mode_.period_us() + kJitter_us * (2.0 * random.uniform() - 1.0));
}

Utime Mirror::sent_at(std::int64_t number) const {
  return start_of(number) + static_cast<Utime>(mode_.period_us() * kField_deg / 360.0) + kAfterLastBeam;
}

std::int64_t Mirror::last_sent_before(Utime now) const {
  auto turn = static_cast<std::int64_t>(static_cast<double>(now) / mode_.period_us()) + 1;
  while (turn > 0 && sent_at(turn) > now) --turn;
  return turn;
}

}  // namespace scanway::simulator
