#include "common/delivery/kernel_drops.h"

#include <fstream>
#include <sstream>
#include <string>

namespace scanway {

// /proc/net/snmp: for each protocol a line of names, and below it a line of numbers.
std::int64_t kernel_drops() {
  std::ifstream file("/proc/self/net/snmp");
  for (std::string names, numbers; std::getline(file, names) && std::getline(file, numbers);) {
    if (!names.starts_with("Udp:")) continue;
    std::istringstream name_stream(names), number_stream(numbers);
    for (std::string name, number; name_stream >> name && number_stream >> number;) {
      if (name == "RcvbufErrors") return std::stoll(number);
    }
  }
  return 0;
}

}  // namespace scanway
