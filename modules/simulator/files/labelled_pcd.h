#pragma once

#include <string>

#include "modules/simulator/core/laser/raw_sweep.h"

namespace scanway::simulator {

/// Writes a simulated sweep as binary PCD 0.7: x y z (float32, metres, `base`), intensity (float32: RSSI), label
/// (uint32, the numbers of Label), time_us (int32, microseconds after the sweep's last point: none above 0). VIEWPOINT
/// is the sensor's centre. Whole or not at all; throws InputError when the file cannot be written.
void write_labelled_pcd(const std::string& path, const LabelledSweep& sweep);

}  // namespace scanway::simulator
