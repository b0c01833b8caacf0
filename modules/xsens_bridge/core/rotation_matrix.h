#pragma once

#include "modules/xsens_bridge/core/item.h"

namespace scanway::xsens {

/// A 3x3 matrix row by row, from the wire's R11, R21, R31, R12, ... Recorded messages that hold both matrix and
/// quaternion say so: read row by row, as some drivers do, the matrix would be the inverse rotation.
inline Numbers rows_from_columns(const Numbers& wire) {
  return {wire[0], wire[3], wire[6], wire[1], wire[4], wire[7], wire[2], wire[5], wire[8]};
}

}  // namespace scanway::xsens
