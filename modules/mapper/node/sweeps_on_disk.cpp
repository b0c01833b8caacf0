#include "modules/mapper/node/sweeps_on_disk.h"

#include <utility>

#include "common/messages/codec.h"
#include "common/messages/sweep_message.h"

namespace scanway {

void SweepsOnDisk::keep(const Sweep& sweep) {
  std::vector<std::uint8_t> bytes = encode(sweep);
  Kept kept{end_, bytes.size(), {}, sweep.R_world_sweep};
  if (file_.write(bytes, end_)) {
    end_ += static_cast<std::int64_t>(bytes.size());
  } else {
    kept.bytes = std::move(bytes);
  }
  sweeps_.push_back(std::move(kept));
}

Sweep SweepsOnDisk::fetch(std::size_t number) const {
  const Kept& kept = sweeps_.at(number);
  std::vector<std::uint8_t> bytes = kept.bytes;
  if (bytes.empty()) {
    bytes.resize(kept.size);
    file_.read(bytes, kept.offset);
  }
  Sweep sweep = decode<Sweep>(bytes);
  sweep.R_world_sweep = kept.R_world_sweep;
  return sweep;
}

}  // namespace scanway
