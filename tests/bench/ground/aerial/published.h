#pragma once

#include <array>

namespace scanway::bench {

/// A filter's total errors as its source prints them, percent. Nothing of it was run here.
struct Published {
  const char* filter;
  const char* source;
  double samp11, samp53;
};

/// The eight of the comparison that the samples come from, each by its own people; and SMRF, with the parameters that
/// were best for each sample.
inline constexpr std::array<Published, 9> kPublished = {{
    {"Axelsson", "Sithole and Vosselman 2004", 10.76, 8.91},
    {"Pfeifer", "Sithole and Vosselman 2004", 17.35, 12.60},
    {"Sohn", "Sithole and Vosselman 2004", 20.49, 20.19},
    {"Roggero", "Sithole and Vosselman 2004", 20.80, 17.29},
    {"Elmqvist", "Sithole and Vosselman 2004", 22.40, 48.45},
    {"Sithole", "Sithole and Vosselman 2004", 23.25, 37.07},
    {"Wack", "Sithole and Vosselman 2004", 24.02, 27.24},
    {"Brovelli", "Sithole and Vosselman 2004", 36.96, 52.81},
    {"SMRF, best for each sample", "Pingel et al. 2013", 8.28, 2.43},
}};

}  // namespace scanway::bench
