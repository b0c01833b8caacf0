#pragma once

#include <string>
#include <vector>

namespace scanway::architecture {

/// A file of the source tree.
struct SourceFile {
  std::string path;  ///< From the source tree's root.
  std::string text;
};

/// Every text file of the tree under `root`, by path; without builds, hidden folders and recorded logs.
std::vector<SourceFile> source_files(const std::string& root);

bool is_cpp(const SourceFile& file);

/// The text without comments and without what stands in quotes; line breaks stay.
std::string code_of(const std::string& text);

/// The paths of all #include lines, system headers in their angle brackets.
std::vector<std::string> includes_of(const std::string& text);

}  // namespace scanway::architecture
