// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/gmsh.hpp"

#include "mesh_text.hpp"
#include "tag_index.hpp"

#include <map>

namespace tetrarch::format {
namespace {

/// Nodes and dimension of Gmsh's element types 1 to 31; a type that is not here is unknown.
struct ElementType {
  int nodes;
  int dimension;
};
constexpr std::array<ElementType, 32> element_types{
    {{0, 0},  {2, 1},  {3, 2},  {4, 2},  {4, 3}, {8, 3}, {6, 3},  {5, 3},  {3, 1},  {6, 2}, {9, 2},
     {10, 3}, {27, 3}, {18, 3}, {14, 3}, {1, 0}, {8, 2}, {20, 3}, {15, 3}, {13, 3}, {9, 2}, {10, 2},
     {12, 2}, {15, 2}, {15, 2}, {21, 2}, {4, 1}, {5, 1}, {6, 1},  {20, 3}, {35, 3}, {56, 3}}};
constexpr int triangle_type = 2;
constexpr int tetrahedron_type = 4;

/// A node in text is at least "1 0 0 0\n", an element of either version at least as long.
constexpr std::size_t shortest_line = 8;

/// Integers and reals of a section, as text or as the bytes of this file.
class GmshNumbers {
public:
  explicit GmshNumbers(MeshCursor& in) : in_(in) {}

  void set_binary(bool swapped) {
    binary_ = true;
    swapped_ = swapped;
  }
  bool is_binary() const { return binary_; }

  /// Binary version 4.1 writes counts and tags with 8 bytes, the rest and all of version 2 with 4.
  template <class Stored>
  std::int64_t integer(std::string_view expected, std::int64_t least, std::int64_t greatest) {
    if (!binary_) return in_.integer(expected, least, greatest);
    const auto value =
        static_cast<std::int64_t>(load<Stored>(in_.bytes(sizeof(Stored), expected).data(), swapped_));
    if (value < least || value > greatest) in_.fail(std::to_string(value), expected);
    return value;
  }
  double real(std::string_view expected) {
    if (!binary_) return in_.number(expected);
    return load<double>(in_.bytes(sizeof(double), expected).data(), swapped_);
  }
  std::array<double, 3> point() {
    const double x = real("a coordinate");
    const double y = real("a coordinate");
    return {x, y, real("a coordinate")};
  }
  template <class Stored>
  std::int64_t count(std::string_view expected) {
    return integer<Stored>(expected, 0, most_elements);
  }
  template <class Stored>
  int any(std::string_view expected) {
    return static_cast<int>(integer<Stored>(expected, -most_elements - 1, most_elements));
  }
  template <class Stored>
  int tag(std::string_view expected) {
    return static_cast<int>(integer<Stored>(expected, 1, most_elements));
  }

private:
  MeshCursor& in_;
  bool binary_ = false;
  bool swapped_ = false;
};

class GmshReader {
public:
  GmshReader(std::string_view text, const std::string& source) : in_(text, source), numbers_(in_) {
    soup_.source = source;
  }

  Soup read() && {
    read_format();
    while (!in_.at_end()) {
      const std::string_view section = in_.token("a section");
      if (section.front() != '$') in_.fail(section, "a section, like $Nodes");
      if (section == "$Entities" && !is_version_2_) {
        read_entities();
        end_section(section);
      } else if (section == "$Nodes") {
        read_nodes();
        end_section(section);
      } else if (section == "$Elements") {
        read_elements();
        end_section(section);
      } else {
        in_.pass_over("$End" + std::string(section.substr(1)));
      }
    }
    drop_empty_tags(soup_);
    return std::move(soup_);
  }

private:
  void read_format() {
    constexpr std::string_view header = "$MeshFormat";
    if (in_.peek() != header) in_.fail(in_.peek(), header);
    in_.token(header);
    const std::string_view version = in_.token("a version");
    is_version_2_ = version == "2" || version.substr(0, 2) == "2.";
    if (!is_version_2_ && version != "4.1") in_.fail(version, "version 2.x or 4.1");
    const bool binary = in_.integer("0 for text or 1 for binary", 0, 1) == 1;
    in_.integer("8 bytes in a real number", 8, 8);
    in_.rest_of_line();
    if (binary) {
      const std::string_view one = in_.bytes(sizeof(std::int32_t), "the integer 1 in 4 bytes");
      const bool swapped = load<std::int32_t>(one.data(), false) != 1;
      if (load<std::int32_t>(one.data(), swapped) != 1) in_.fail(one, "the integer 1 in 4 bytes");
      numbers_.set_binary(swapped);
    }
    end_section(header);
  }

  void end_section(std::string_view section) {
    const std::string end = "$End" + std::string(section.substr(1));
    const std::string_view found = in_.token(end);
    if (found != end) in_.fail(found, end);
  }

  /// Points, curves, surfaces and volumes; a point has one place and bounds nothing, others have a box.
  void read_entities() {
    in_.rest_of_line();
    std::array<std::int64_t, 4> counts{};
    for (std::int64_t& count : counts) count = numbers_.count<std::uint64_t>("the number of entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
        const int tag = numbers_.any<std::int32_t>("the tag of an entity");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) numbers_.real("a coordinate");
        const std::int64_t groups = numbers_.count<std::uint64_t>("the number of physical groups");
        for (std::int64_t k = 0; k < groups; ++k) {
          const int group = numbers_.any<std::int32_t>("the tag of a physical group");
          if (dimension == 2 && k == 0) group_of_surface_[tag] = group;
        }
        if (dimension == 0) continue;
        const std::int64_t bounding = numbers_.count<std::uint64_t>("the number of bounding entities");
        for (std::int64_t k = 0; k < bounding; ++k) numbers_.any<std::int32_t>("the tag of an entity");
      }
  }

  void read_nodes() {
    if (!soup_.points.empty()) in_.fail("$Nodes", "only one such section");
    if (is_version_2_) {
      read_nodes_2();
    } else {
      read_nodes_41();
    }
    index_ = TagIndex(soup_.point_labels.numbers);
    if (const auto tag = index_.repeated())
      in_.fail("$EndNodes", "nodes of different tags, but several have the tag " + std::to_string(*tag));
  }

  void read_nodes_2() {
    const std::int64_t count = in_.integer("the number of nodes", 0, most_elements);
    in_.rest_of_line();
    soup_.points.reserve(in_.believable(count, shortest_line));
    for (std::int64_t i = 0; i < count; ++i) {
      const int tag = numbers_.tag<std::int32_t>("the tag of a node");
      note(soup_.point_labels, tag, in_.line());
      soup_.points.push_back(numbers_.point());
    }
  }

  void read_nodes_41() {
    in_.rest_of_line();
    const std::int64_t blocks = numbers_.count<std::uint64_t>("the number of blocks");
    const std::int64_t count = numbers_.count<std::uint64_t>("the number of nodes");
    for (int i = 0; i < 2; ++i) numbers_.count<std::uint64_t>("the tag of a node");
    soup_.points.reserve(in_.believable(count, shortest_line));
    for (std::int64_t b = 0; b < blocks; ++b) read_node_block();
    if (static_cast<std::int64_t>(soup_.points.size()) != count)
      in_.fail(std::to_string(soup_.points.size()) + " nodes", std::to_string(count) + " as announced");
  }

  void read_node_block() {
    const std::int64_t dimension = numbers_.integer<std::int32_t>("the dimension of an entity", 0, 3);
    numbers_.any<std::int32_t>("the tag of an entity");
    const bool parametric = numbers_.integer<std::int32_t>("0 or 1 for parametric", 0, 1) == 1;
    const std::int64_t count = numbers_.count<std::uint64_t>("the number of nodes in the block");
    for (std::int64_t i = 0; i < count; ++i) {
      const int tag = numbers_.tag<std::uint64_t>("the tag of a node");
      note(soup_.point_labels, tag, in_.line());
    }
    for (std::int64_t i = 0; i < count; ++i) {
      soup_.points.push_back(numbers_.point());
      for (std::int64_t p = 0; parametric && p < dimension; ++p) numbers_.real("a parameter");
    }
  }

  void read_elements() {
    if (is_version_2_) {
      read_elements_2();
    } else {
      read_elements_41();
    }
  }

  /// Text has elements one by one with their type, binary has them in blocks of one type and number of tags.
  void read_elements_2() {
    const std::int64_t count = in_.integer("the number of elements", 0, most_elements);
    in_.rest_of_line();
    for (std::int64_t done = 0; done < count;) {
      const bool text = !numbers_.is_binary();
      int number = text ? numbers_.tag<std::int32_t>("the tag of an element") : 0;
      const int type = read_type();
      const std::int64_t in_block =
          text ? 1 : numbers_.integer<std::int32_t>("the elements in the block", 1, count - done);
      const std::int64_t tags = numbers_.integer<std::int32_t>("the number of tags", 0, most_elements);
      for (std::int64_t i = 0; i < in_block; ++i, ++done) {
        if (!text) number = numbers_.tag<std::int32_t>("the tag of an element");
        int patch = 0; // the physical group, then the surface
        for (std::int64_t k = 0; k < tags; ++k) {
          const int tag = numbers_.any<std::int32_t>("a tag");
          if (k < 2 && patch == 0) patch = tag;
        }
        read_element<std::int32_t>(type, number, patch);
      }
    }
  }

  void read_elements_41() {
    in_.rest_of_line();
    const std::int64_t blocks = numbers_.count<std::uint64_t>("the number of blocks");
    numbers_.count<std::uint64_t>("the number of elements");
    for (int i = 0; i < 2; ++i) numbers_.count<std::uint64_t>("the tag of an element");
    for (std::int64_t b = 0; b < blocks; ++b) {
      numbers_.integer<std::int32_t>("the dimension of an entity", 0, 3);
      const int entity = numbers_.any<std::int32_t>("the tag of an entity");
      const auto group = group_of_surface_.find(entity);
      const int patch = group == group_of_surface_.end() ? entity : group->second;
      const int type = read_type();
      const std::int64_t count = numbers_.count<std::uint64_t>("the number of elements in the block");
      if (type == tetrahedron_type)
        soup_.tetrahedra.reserve(soup_.tetrahedra.size() + in_.believable(count, shortest_line));
      for (std::int64_t i = 0; i < count; ++i)
        read_element<std::uint64_t>(type, numbers_.tag<std::uint64_t>("the tag of an element"), patch);
    }
  }

  int read_type() {
    const int type = static_cast<int>(
        numbers_.integer<std::int32_t>("an element type, 1 to 31", 1, element_types.size() - 1));
    const ElementType& about = element_types[static_cast<std::size_t>(type)];
    const std::string nodes = std::to_string(about.nodes);
    if (about.dimension == 3 && type != tetrahedron_type)
      in_.fail("volume elements of " + nodes + " nodes", "tetrahedra of 4 nodes alone");
    if (about.dimension == 2 && type != triangle_type && !warned_) {
      warned_ = true;
      soup_.warnings.emplace_back("surface elements other than triangles of 3 nodes were passed over");
    }
    return type;
  }

  template <class Stored>
  void read_element(int type, int number, int patch) {
    const int line = in_.line();
    if (type == triangle_type) {
      soup_.triangles.push_back(read_node_tags<Stored, 3>());
      soup_.triangle_tags.push_back(patch);
      note(soup_.triangle_labels, number, line);
    } else if (type == tetrahedron_type) {
      soup_.tetrahedra.push_back(read_node_tags<Stored, 4>());
      note(soup_.tetrahedron_labels, number, line);
    } else {
      for (int i = 0; i < element_types[static_cast<std::size_t>(type)].nodes; ++i)
        numbers_.tag<Stored>("the tag of a node");
    }
  }

  template <class Stored, std::size_t corners>
  std::array<int, corners> read_node_tags() {
    std::array<int, corners> out{};
    for (int& corner : out) {
      const int tag = numbers_.tag<Stored>("the tag of a node");
      const std::optional<int> index = index_.find(tag);
      if (!index) in_.fail(std::to_string(tag), "the tag of a node");
      corner = *index;
    }
    return out;
  }

  MeshCursor in_;
  GmshNumbers numbers_;
  Soup soup_;
  TagIndex index_{Runs()};
  std::map<int, int> group_of_surface_;
  bool is_version_2_ = false;
  bool warned_ = false;
};

template <class Elements>
void append_block(std::string& out, int dimension, int type, const Elements& elements, int first_tag) {
  if (elements.empty()) return;
  out +=
      std::to_string(dimension) + " 1 " + std::to_string(type) + " " + std::to_string(elements.size()) + "\n";
  for (const auto& corners : elements) {
    append_number(out, first_tag++);
    out += ' ';
    append_line(out, corners, "\n", 1);
  }
}

/// The first line of a section of so many elements in so many blocks.
std::string section_head(std::size_t blocks, std::size_t count) {
  const std::string number = std::to_string(count);
  return std::to_string(blocks) + " " + number + (count == 0 ? " 0 " : " 1 ") + number + "\n";
}

} // namespace

Soup read_gmsh(std::string_view text, const std::string& source) {
  return GmshReader(text, source).read();
}

std::string write_gmsh(const Soup& soup) {
  std::string out = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n";
  const std::size_t points = soup.points.size();
  out += section_head(1, points) + "3 1 0 " + std::to_string(points) + "\n";
  for (std::size_t i = 1; i <= points; ++i) {
    append_number(out, i);
    out += '\n';
  }
  for (const auto& p : soup.points) append_line(out, p, "\n");
  const std::size_t triangles = soup.triangles.size();
  const std::size_t tetrahedra = soup.tetrahedra.size();
  out += "$EndNodes\n$Elements\n" +
         section_head((triangles > 0 ? 1U : 0U) + (tetrahedra > 0 ? 1U : 0U), triangles + tetrahedra);
  append_block(out, 2, triangle_type, soup.triangles, 1);
  append_block(out, 3, tetrahedron_type, soup.tetrahedra, static_cast<int>(triangles) + 1);
  return out + "$EndElements\n";
}

} // namespace tetrarch::format
