#pragma once

#include <string>
#include <vector>

#include "tests/architecture/source_file.h"

namespace scanway::architecture {

/// Each rule names what breaks it, one line each; nothing when all is well.
using Violations = std::vector<std::string>;

/// Who may include whom (docs/conventions.md).
Violations include_violations(const SourceFile& file);

/// What a core must not do: read a clock, draw from the library's random numbers, talk LCM, open files, write to the
/// terminal, call those functions of the C library that differ from CPU to CPU.
Violations purity_violations(const SourceFile& file);

/// Paths of one machine in what everybody gets.
Violations machine_path_violations(const SourceFile& file);

/// Files that are too long to be one noun.
Violations length_violations(const SourceFile& file, long most_lines);

/// Commands that a header of modules/tools offers, and that no page of docs mentions.
Violations undocumented_commands(const std::vector<SourceFile>& files);

}  // namespace scanway::architecture
