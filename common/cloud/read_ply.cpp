#include <algorithm>
#include <array>

#include "common/cloud/cloud_formats.h"
#include "common/cloud/ply_header.h"
#include "common/cloud/scalar_columns.h"
#include "common/files/printable.h"
#include "common/files/text_lines.h"

namespace scanway::cloud_formats {
namespace {

/// x, y, z and, if the file has it, intensity of one vertex.
using Vertex = std::array<float, 4>;

CloudFields fields_of(const PlyElement& vertices, const std::string& file) {
  std::vector<std::string> names;
  for (const PlyProperty& property : vertices.properties) names.push_back(property.name);
  CloudFields fields = choose_fields(names, file);
  for (const std::size_t index : fields.xyz) {
    if (!vertices.properties[index].list_count_type) continue;
    refuse(file, "its property " + names[index] + " is a list; export the cloud with plain x y z");
  }
  if (fields.intensity && vertices.properties[*fields.intensity].list_count_type) fields.intensity.reset();
  return fields;
}

/// Which of a vertex's four values the property is; 4: none.
std::size_t place_of(const CloudFields& chosen, std::size_t property) {
  const auto axis = std::find(chosen.xyz.begin(), chosen.xyz.end(), property);
  if (axis != chosen.xyz.end()) return static_cast<std::size_t>(axis - chosen.xyz.begin());
  return chosen.intensity == property ? 3 : 4;
}

void add(PointCloud& cloud, const CloudFields& chosen, const Vertex& vertex) {
  cloud.points.emplace_back(vertex[0], vertex[1], vertex[2]);
  if (chosen.intensity) cloud.intensity.push_back(vertex[3]);
}

/// The elements of a file one after the other. Elements that hold no vertices are walked over all the same: a file that
/// ends within them is cut.
class BinaryElements {
 public:
  BinaryElements(std::string_view bytes, bool big_endian, const std::string& file)
      : rest_(bytes), big_endian_(big_endian), file_(file) {}

  void skip(const PlyElement& element) {
    check_count(element);
    if (!element.has_list()) {
      rest_.remove_prefix(element.count * element.least_bytes());
      return;
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) take(property, element);
    }
  }

  PointCloud read(const PlyElement& element, const CloudFields& chosen) {
    check_count(element);
    return element.has_list() ? read_rows(element, chosen) : read_columns(element, chosen);
  }

 private:
  void check_count(const PlyElement& element) const {
    const std::size_t least = element.least_bytes();
    if (least == 0 || element.count <= rest_.size() / least) return;
    refuse(file_, "promises " + std::to_string(element.count) + " of element " + in_quotes(element.name) +
                      ", but only " + std::to_string(rest_.size()) +
                      " bytes follow; it is cut or damaged, copy it again");
  }

  PointCloud read_columns(const PlyElement& element, const CloudFields& chosen) {
    const std::size_t stride = element.least_bytes();
    const auto column = [&](std::size_t wanted) {
      const char* data = rest_.data();
      for (std::size_t i = 0; i < wanted; ++i) data += size_of(element.properties[i].type);
      return ScalarColumn{data, stride, element.properties[wanted].type, big_endian_};
    };
    const ScalarColumn intensity = chosen.intensity ? column(*chosen.intensity) : ScalarColumn{};
    PointCloud cloud =
        gather_columns(element.count, {column(chosen.xyz[0]), column(chosen.xyz[1]), column(chosen.xyz[2])},
                       chosen.intensity ? &intensity : nullptr);
    rest_.remove_prefix(element.count * stride);
    return cloud;
  }

  PointCloud read_rows(const PlyElement& element, const CloudFields& chosen) {
    PointCloud cloud;
    cloud.points.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      Vertex vertex{};
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const char* data = take(element.properties[p], element);
        const std::size_t place = place_of(chosen, p);
        if (place < 4) vertex[place] = static_cast<float>(load_scalar(data, element.properties[p].type, big_endian_));
      }
      add(cloud, chosen, vertex);
    }
    return cloud;
  }

  /// Steps over one property and says where it was.
  const char* take(const PlyProperty& property, const PlyElement& element) {
    std::uint64_t entries = 1;
    if (property.list_count_type) {
      const double length =
          load_scalar(take_bytes(size_of(*property.list_count_type), element), *property.list_count_type, big_endian_);
      if (length < 0 || length > static_cast<double>(rest_.size())) refuse_cut(element);
      entries = static_cast<std::uint64_t>(length);
    }
    return take_bytes(entries * size_of(property.type), element);
  }

  const char* take_bytes(std::uint64_t count, const PlyElement& element) {
    if (count > rest_.size()) refuse_cut(element);
    const char* data = rest_.data();
    rest_.remove_prefix(count);
    return data;
  }

  [[noreturn]] void refuse_cut(const PlyElement& element) const {
    refuse(file_, "ends within element " + in_quotes(element.name) + "; it is cut or damaged, copy it again");
  }

  std::string_view rest_;
  bool big_endian_;
  const std::string& file_;
};

/// The same for text: one of an element a line.
class AsciiElements {
 public:
  AsciiElements(std::string_view bytes, std::size_t lines_before, const std::string& file)
      : size_(bytes.size()), lines_(bytes, lines_before), file_(file) {}

  void skip(const PlyElement& element) { walk(element, {}, nullptr); }

  PointCloud read(const PlyElement& element, const CloudFields& chosen) {
    PointCloud cloud;
    cloud.points.reserve(std::min<std::uint64_t>(element.count, size_ / 6 + 1));  // "0 0 0\n"
    walk(element, chosen, &cloud);
    return cloud;
  }

 private:
  void walk(const PlyElement& element, const CloudFields& chosen, PointCloud* cloud) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      std::string_view line = next_line(element, i);
      Vertex vertex{};
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const std::string_view token = take_property(line, element.properties[p]);
        const std::size_t place = cloud == nullptr ? 4 : place_of(chosen, p);
        if (place < 4) vertex[place] = parse_coordinate(token, file_, number());
      }
      if (!is_blank(line)) refuse_line(file_, number(), "more numbers than properties; export the cloud again");
      if (cloud != nullptr) add(*cloud, chosen, vertex);
    }
  }

  std::string_view next_line(const PlyElement& element, std::uint64_t before) {
    auto line = lines_.next();
    while (line && is_blank(*line)) line = lines_.next();
    if (line) return *line;
    refuse(file_, "promises " + std::to_string(element.count) + " of element " + in_quotes(element.name) +
                      " and holds " + std::to_string(before) + "; it is cut, copy it again");
  }

  /// The property's token; of a list, the token of its length.
  std::string_view take_property(std::string_view& line, const PlyProperty& property) const {
    const std::string_view token = take_token(line);
    if (token.empty()) refuse_line(file_, number(), "fewer numbers than properties; the file is cut or damaged");
    if (!property.list_count_type) return token;
    const auto length = parse_count(token);
    if (!length) refuse_line(file_, number(), in_quotes(token) + " is no length of a list; export the cloud again");
    for (std::uint64_t i = 0; i < *length; ++i) {
      if (take_token(line).empty()) refuse_line(file_, number(), "this list is cut; export the cloud again");
    }
    return token;
  }

  std::size_t number() const { return lines_.number(); }

  std::size_t size_;
  TextLines lines_;
  const std::string& file_;
};

template <class Elements>
PointCloud read_elements(const PlyHeader& header, Elements elements, const std::string& file) {
  PointCloud cloud;
  bool found = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex" && !found) {
      cloud = elements.read(element, fields_of(element, file));
      found = true;
    } else {
      elements.skip(element);
    }
  }
  if (!found) refuse(file, "has no element vertex; export it as points");
  return cloud;
}

}  // namespace

PointCloud read_ply(std::string_view bytes, const std::string& file) {
  const PlyHeader header = take_ply_header(bytes, file);
  if (header.format == PlyFormat::ascii) return read_elements(header, AsciiElements(bytes, header.lines, file), file);
  const bool big_endian = header.format == PlyFormat::binary_big_endian;
  return read_elements(header, BinaryElements(bytes, big_endian, file), file);
}

}  // namespace scanway::cloud_formats
