#include "common/process/params_teller.h"

#include <utility>

#include "common/bus/channels.h"
#include "common/config/robot_file.h"
#include "common/messages/codec.h"
#include "common/messages/objects.h"
#include "common/messages/params_message.h"

namespace scanway {

ParamsTeller::ParamsTeller(Bus& bus, std::string process, const Robot& robot, Utime start)
    : bus_(bus),
      process_(std::move(process)),
      start_(start),
      message_(encode(params_message(start, robot_text(robot)))) {}

void ParamsTeller::tell() { publish_object(bus_, channel::kParams, message_, process_, start_ + told_++, start_); }

}  // namespace scanway
