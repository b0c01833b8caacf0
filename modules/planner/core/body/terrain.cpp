#include "modules/planner/core/body/terrain.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace scanway::planning {
namespace {

constexpr std::int32_t kBlock = Frame::kBlock;
/// Parts of a metre's cost that a weight can tell apart.
constexpr std::uint32_t kWeightParts = 64;

/// Two discs of this radius about neighbouring cells cover the body's circle all the way between them.
double roomy_radius(const Body& body) { return std::sqrt(body.circumscribed() * body.circumscribed() + 0.5); }

DiscDilation discs_of(const Body& body, BodyMode mode) {
  return mode == BodyMode::footprint ? DiscDilation(body.inscribed(), roomy_radius(body)) : DiscDilation(0.0, 0.0);
}

std::uint32_t parts(double factor) {
  return static_cast<std::uint32_t>(std::floor(std::clamp(factor, 0.0, 1e6) * kWeightParts + 0.5));
}

}  // namespace

Terrain::Terrain(const CostMap& map, const CellRectangle& bounds, const Body& body, const TerrainOptions& options)
    : options_(options),
      body_(&body),
      bounds_(bounds),
      discs_(discs_of(body, options.mode)),
      frame_(frame_around(bounds, discs_.reach() + 2)),
      weight_one_(options.mode == BodyMode::point && options.unknown != UnknownPolicy::price ? 1 : kWeightParts),
      occupied_(frame_),
      free_(frame_),
      blocked_(frame_),
      cells_(frame_.cells()),
      slots_(frame_.cells()) {
  unseen_weight_ = weight(CellState::unknown, 0);
  seen_weight_ = weight(CellState::free, 0);
  if (options.unknown == UnknownPolicy::never) blocked_.fill();
  Changes changes;
  for (const auto& tile : map.tiles) load(map, tile.first, changes);
}

bool Terrain::holds_tile(Cell tile) const {
  const std::int32_t reach = discs_.reach() + 2;
  const Cell low = {tile.x * CostTile::kSide, tile.y * CostTile::kSide};
  return frame_.contains({low.x - reach, low.y - reach}) &&
         frame_.contains({low.x + CostTile::kSide + reach, low.y + CostTile::kSide + reach});
}

bool Terrain::grow(const CellRectangle& bounds) {
  const CellRectangle all = {{std::min(bounds.low.x, bounds_.low.x), std::min(bounds.low.y, bounds_.low.y)},
                             {std::max(bounds.high.x, bounds_.high.x), std::max(bounds.high.y, bounds_.high.y)}};
  if (all == bounds_) return true;
  // Under `never` what lay outside was unknown, and so blocked, anyway.
  if (options_.unknown != UnknownPolicy::never) return false;
  bounds_ = all;
  return true;
}

std::uint16_t Terrain::weight(CellState state, std::uint32_t cost) const {
  std::uint64_t weight = weight_one_;
  if (state == CellState::unknown && options_.unknown == UnknownPolicy::price) weight += parts(options_.unknown_price);
  if (options_.mode != BodyMode::point && cost != 0) {
    // A lethal cell is left to the footprint itself, which knows the headings.
    weight += (std::uint64_t{parts(options_.clearance_weight)} * (cost == kCostLethal ? kCostOne : cost)) / kCostOne;
  }
  return static_cast<std::uint16_t>(std::min<std::uint64_t>(weight, kWeightMask));
}

void Terrain::load(const CostMap& map, Cell tile, Changes& changes) {
  static const CostTile kUnknown{};
  const auto found = map.tiles.find(tile);
  const CostTile& source = found == map.tiles.end() ? kUnknown : found->second;
  const std::int32_t x0 = tile.x * CostTile::kSide - frame_.low.x;
  const std::int32_t y0 = tile.y * CostTile::kSide - frame_.low.y;
  for (std::int32_t row = 0; row < CostTile::kSide; ++row) {
    for (std::int32_t column = 0; column < CostTile::kSide; column += 64) {
      const auto at = static_cast<std::size_t>(row * CostTile::kSide + column);
      load_word(&source.state[at], &source.cost[at], y0 + row, x0 + column, changes);
    }
  }
  tiles_.insert(tile);
}

void Terrain::load_word(const CellState* states, const std::uint32_t* costs, std::int32_t y, std::int32_t x,
                        Changes& changes) {
  std::uint64_t occupied = 0;
  std::uint64_t free = 0;
  const std::uint32_t first = frame_.index_of_offset({x, y});
  for (std::uint32_t i = 0; i < 64; ++i) {
    occupied |= std::uint64_t{states[i] == CellState::occupied} << i;
    free |= std::uint64_t{states[i] == CellState::free} << i;
    const std::uint16_t field = cells_[first + i].field();
    const std::uint16_t known = field & kWeightMask;
    const std::uint16_t now = weight(states[i], costs[i]);
    // What costs nothing needs no memory before somebody asks.
    if (known == now || (known == 0 && costs[i] == 0)) continue;
    if (class_of(field) != Class::unasked) changes.weights.push_back(first + i);
    cells_[first + i].set_field(static_cast<std::uint16_t>((field & ~kWeightMask) | now));
  }
  const std::uint64_t blocked = options_.unknown == UnknownPolicy::never ? ~free : occupied;
  const std::uint64_t before = blocked_.word(y, x / 64);
  for (std::uint64_t differ = blocked ^ before; differ != 0; differ &= differ - 1) {
    changes.blocked.push_back(first + static_cast<std::uint32_t>(__builtin_ctzll(differ)));
  }
  occupied_.set_word(y, x / 64, occupied);
  free_.set_word(y, x / 64, free);
  blocked_.set_word(y, x / 64, blocked);
}

std::uint16_t Terrain::ask(std::uint32_t index) {
  asked_.push_back(index & ~(Frame::kBlockCells - 1));
  name_block(asked_.back());
  return cells_[index].field();
}

void Terrain::name_block(std::uint32_t first) {
  const Cell low = frame_.offset_of(first);
  Block blocked;
  Block roomy;
  classify(low.y, low.x / kBlock, blocked, roomy);
  for (std::uint32_t y = 0; y < kBlock; ++y) {
    const std::int32_t line = low.y + static_cast<std::int32_t>(y);
    const std::uint64_t seen = occupied_.word(line, low.x / kBlock) | free_.word(line, low.x / kBlock);
    CellWord* words = &cells_[first + y * kBlock];
    for (std::uint32_t x = 0; x < kBlock; ++x) {
      const Class now = (blocked[y] >> x) & 1 ? Class::blocked : (roomy[y] >> x) & 1 ? Class::roomy : Class::tight;
      const std::uint16_t known = words[x].field() & kWeightMask;
      const std::uint16_t weight = known != 0 ? known : (seen >> x) & 1 ? seen_weight_ : unseen_weight_;
      words[x].set_field(static_cast<std::uint16_t>(weight | static_cast<std::uint16_t>(now) << kClassShift));
    }
  }
}

void Terrain::forget_search() {
  for (const std::uint32_t first : asked_) {
    for (std::uint32_t i = 0; i < Frame::kBlockCells; ++i) {
      cells_[first + i].bits &= std::uint64_t{0xFFFF} << CellWord::kFieldShift;
    }
  }
}

void Terrain::classify(std::int32_t row, std::int32_t column, Block& blocked, Block& roomy) const {
  const Cell low = {frame_.low.x + column * kBlock, frame_.low.y + row};
  if (options_.mode == BodyMode::footprint) {
    // At the frame's rim nothing is within the bounds; looking further would leave the frame.
    const bool rim = !holds_tile(CostMap::tile_of(low));
    const DiscDilation::Result near = rim ? DiscDilation::Result{} : discs_.around(blocked_, row, column);
    blocked = near.small;
    for (std::size_t y = 0; y < kBlock; ++y) roomy[y] = ~near.large[y];
  }
  for (std::int32_t y = 0; y < kBlock; ++y) {
    const auto at = static_cast<std::size_t>(y);
    if (options_.mode != BodyMode::footprint) blocked[at] = blocked_.word(row + y, column);
    if (options_.mode != BodyMode::footprint) roomy[at] = ~blocked[at];
    if (options_.mode == BodyMode::footprint) blocked[at] |= blocked_.word(row + y, column);
    for (std::int32_t x = 0; x < kBlock; ++x) {
      if (!bounds_.contains({low.x + x, low.y + y})) blocked[at] |= std::uint64_t{1} << x;
    }
  }
}

std::uint32_t Terrain::slot(std::uint32_t index) {
  if (slots_[index] == 0) {
    tight_.push_back({index, find_headings(index)});
    slots_[index] = static_cast<std::uint32_t>(tight_.size());
  }
  return slots_[index] - 1;
}

bool Terrain::is_clear(const Spans& spans, std::uint32_t index) const {
  const Cell at = frame_.offset_of(index);
  return !blocked_.any(spans, at.x, at.y);
}

std::uint16_t Terrain::find_headings(std::uint32_t index) const {
  std::uint16_t headings = 0;
  for (int heading = 0; heading < kHeadings; ++heading) {
    if (is_clear(body_->standing(heading), index)) headings |= static_cast<std::uint16_t>(1u << heading);
  }
  return headings;
}

std::vector<std::uint32_t> Terrain::update(const CostMap& map, const std::vector<Cell>& tiles) {
  Changes changes;
  for (const Cell& tile : tiles) load(map, tile, changes);
  std::vector<std::uint32_t> changed = std::move(changes.weights);
  reclassify_near(changes.blocked, changed);
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

void Terrain::reclassify_near(const std::vector<std::uint32_t>& cells, std::vector<std::uint32_t>& changed) {
  // The rectangle of the changed cells of each block; what is within reach of it is looked at again.
  std::map<Cell, CellRectangle> sources;
  for (const std::uint32_t index : cells) {
    const Cell cell = frame_.offset_of(index);
    CellRectangle& box =
        sources.try_emplace({cell.x / kBlock, cell.y / kBlock}, CellRectangle{cell, cell}).first->second;
    box.low = {std::min(box.low.x, cell.x), std::min(box.low.y, cell.y)};
    box.high = {std::max(box.high.x, cell.x + 1), std::max(box.high.y, cell.y + 1)};
  }
  const std::int32_t reach = options_.mode == BodyMode::footprint ? discs_.reach() + 2 : 0;
  std::set<Cell> blocks;
  for (const auto& [block, box] : sources) {
    const CellRectangle around = {
        {std::max(box.low.x - reach, 0), std::max(box.low.y - reach, 0)},
        {std::min(box.high.x + reach, frame_.width), std::min(box.high.y + reach, frame_.height)}};
    for (std::int32_t y = around.low.y / kBlock; y <= (around.high.y - 1) / kBlock; ++y) {
      for (std::int32_t x = around.low.x / kBlock; x <= (around.high.x - 1) / kBlock; ++x) blocks.insert({x, y});
    }
    for (std::int32_t y = around.low.y; options_.mode == BodyMode::footprint && y < around.high.y; ++y) {
      for (std::int32_t x = around.low.x; x < around.high.x; ++x) {
        const std::uint32_t index = frame_.index_of_offset({x, y});
        if (slots_[index] == 0) continue;
        tight_[slots_[index] - 1].headings = find_headings(index);
        changed.push_back(index);
      }
    }
  }
  for (const Cell& block : blocks) {
    reclassify_block(frame_.index_of_offset({block.x * kBlock, block.y * kBlock}), changed);
  }
}

void Terrain::reclassify_block(std::uint32_t first, std::vector<std::uint32_t>& changed) {
  if (class_of(cells_[first].field()) == Class::unasked) return;
  std::array<std::uint16_t, Frame::kBlockCells> before;
  for (std::uint32_t i = 0; i < before.size(); ++i) before[i] = cells_[first + i].field();
  name_block(first);
  for (std::uint32_t i = 0; i < before.size(); ++i) {
    if (class_of(cells_[first + i].field()) != class_of(before[i])) changed.push_back(first + i);
  }
}

}  // namespace scanway::planning
