#pragma once

#include "common/config/fields.h"
#include "common/robot/robot.h"

namespace scanway {

/// Every key of the robot file, in the order of the file.
void describe(Fields& fields, Robot& robot);

}  // namespace scanway
