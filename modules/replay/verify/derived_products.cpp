#include "modules/replay/verify/derived_products.h"

#include <fmt/format.h>

#include "common/messages/codec.h"
#include "common/messages/digest.h"

namespace scanway {

std::string both_digests(std::int64_t recorded, std::int64_t derived) {
  return fmt::format("digest {} in the log, {} derived from it", hex(static_cast<std::uint64_t>(recorded)),
                     hex(static_cast<std::uint64_t>(derived)));
}

void DerivedProducts::listen(Bus& bus) {
  for (const Channel* product : kMapperProducts) {
    bus.subscribe(product->name, [this, cut = product->cut](const BusMessage& message) {
      if (cut) {
        const auto piece = decode<piece_t>(message.bytes);
        digests_[{std::string(message.channel), piece.key, piece.version}] = piece.digest;
      } else {
        const RecordedName name = name_of(message.channel, message.bytes);
        digests_[{name.channel, name.key, name.version}] = name.digest;
      }
    });
  }
}

std::string DerivedProducts::difference(const RecordedLog& log, Utime sweep) const {
  for (const RecordedName& recorded : log.products_at(sweep)) {
    const std::string difference = this->difference(log, recorded);
    if (!difference.empty()) return text_of(recorded) + ": " + difference;
  }
  return {};
}

std::string DerivedProducts::difference(const RecordedLog& log, const RecordedName& recorded) const {
  const auto derived = digests_.find({recorded.channel, recorded.key, recorded.version});
  const auto object = log.objects().find(recorded);
  const std::string fault = object == log.objects().end() ? std::string() : object->second.fault();
  if (derived == digests_.end()) {
    return fmt::format("digest {} in the log, but nothing of that name is derived from it{}{}",
                       hex(static_cast<std::uint64_t>(recorded.digest)), fault.empty() ? "" : "; ", fault);
  }
  if (!fault.empty()) return fault + "; " + both_digests(recorded.digest, derived->second);
  return derived->second == recorded.digest ? std::string() : both_digests(recorded.digest, derived->second);
}

}  // namespace scanway
