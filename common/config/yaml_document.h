#pragma once

#include <string>
#include <string_view>

#include <yaml-cpp/yaml.h>

namespace scanway {

/// The one YAML document in `text`, a mapping. `name` stands for the file in messages. Throws InputError for what is no
/// text in UTF-8, no YAML, more than one document, or no mapping. Empty text is an empty mapping.
YAML::Node yaml_mapping(std::string_view text, const std::string& name);

/// The line of `node` in its file, from 1; 0 for what has none.
int line_of(const YAML::Node& node);

}  // namespace scanway
