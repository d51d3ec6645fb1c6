// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/gmsh.hpp"

#include "gmsh_numbers.hpp"
#include "mesh_text.hpp"
#include "tag_index.hpp"

#include <cstdlib>
#include <map>
#include <utility>

namespace tetrarch::format {
namespace {

/// A node in text is at least "1 0 0 0\n", an element of either version at least as long.
constexpr std::size_t shortest_gmsh_line = 8;

/// A dimension and the number of an entity of it.
using EntityName = std::pair<int, int>;

struct Entity {
  int group = 0;      ///< the first physical group; 0: none
  int groups = 0;     ///< how many
  EntityName whole{}; ///< of a part that a partition made, what it is part of; else itself
};

/// Where an element belongs: its physical group (0: none) and its entity.
struct Origin {
  int group;
  int entity;
  friend auto operator<=>(const Origin&, const Origin&) = default;
};

/// Which origins there are, numbered from 1, and what labels they become.
class Origins {
public:
  int number(const Origin& origin) {
    return numbers_.try_emplace(origin, static_cast<int>(numbers_.size()) + 1).first->second;
  }
  /// Makes labels of numbers: physical groups if there are any, 0 for what is in none; else entities, but one
  /// alone tells nothing. So no entity's number is taken for a group's.
  void make_labels(std::vector<int>& tags, const char* element, Ledger& passed_over) const {
    std::vector<char> used(numbers_.size() + 1, 0);
    for (const int tag : tags) used[static_cast<std::size_t>(tag)] = 1;
    bool has_groups = false;
    int entities = 0;
    for (const auto& [origin, number] : numbers_) {
      has_groups = has_groups || (used[static_cast<std::size_t>(number)] && origin.group != 0);
      entities += used[static_cast<std::size_t>(number)];
    }
    std::vector<int> label(numbers_.size() + 1, 0);
    for (const auto& [origin, number] : numbers_) {
      if (has_groups)
        label[static_cast<std::size_t>(number)] = origin.group;
      else if (entities > 1)
        label[static_cast<std::size_t>(number)] = origin.entity;
    }
    std::int64_t outside = 0;
    for (int& tag : tags) {
      tag = label[static_cast<std::size_t>(tag)];
      outside += has_groups && tag == 0 ? 1 : 0;
    }
    passed_over.note(std::string("entity of a ") + element + " in no physical group", outside);
  }

private:
  std::map<Origin, int> numbers_;
};

enum class Version : std::uint8_t { v1, v2, v40, v41 };

class GmshReader {
public:
  GmshReader(std::string_view text, const std::string& source) : in_(text, source), numbers_(in_) {
    soup_.source = source;
  }

  Soup read() && {
    while (!in_.at_end()) {
      const std::string section(in_.token("a section"));
      if (section.front() != '$') in_.fail(section, "a section, like $Nodes");
      if (read_section(section)) {
        end_section(section);
      } else {
        if (section != "$Comments") soup_.passed_over.note("section " + section);
        in_.pass_over("$End" + section.substr(1));
      }
    }
    if (!has_format_) in_.fail("", "$MeshFormat");
    cells_.finish();
    origins_.make_labels(soup_.triangle_tags, "triangle", soup_.passed_over);
    origins_.make_labels(soup_.tetrahedron_tags, "tetrahedron", soup_.passed_over);
    drop_empty_tags(soup_);
    return std::move(soup_);
  }

private:
  bool is_4() const { return version_ == Version::v40 || version_ == Version::v41; }

  /// False for a section that is not known.
  bool read_section(const std::string& section) {
    if (section == "$Comments") return false; // which may come before all others
    if (section == "$MeshFormat") {
      read_format();
    } else if (section == "$NOD" || section == "$ELM") {
      has_format_ = true;
      version_ = Version::v1;
      section == "$NOD" ? read_nodes(false) : read_elements();
    } else if (!has_format_) {
      in_.fail(section, "$MeshFormat");
    } else if (section == "$Entities" && is_4()) {
      read_entities(false);
    } else if (section == "$PartitionedEntities" && is_4()) {
      read_entities(true);
    } else if (section == "$Nodes" || section == "$ParametricNodes") {
      read_nodes(section == "$ParametricNodes");
    } else if (section == "$Elements") {
      read_elements();
    } else {
      return false;
    }
    return true;
  }

  void read_format() {
    const std::string_view version = in_.token("a version");
    const auto begins = [version](std::string_view head) { return version.starts_with(head); };
    if (version == "2" || begins("2.")) {
      version_ = Version::v2;
    } else if (begins("4.1")) {
      version_ = Version::v41;
    } else if (version == "4" || begins("4.0")) {
      version_ = Version::v40;
    } else {
      in_.fail(version, "version 2.x, 4.0 or 4.1");
    }
    has_format_ = true;
    const bool binary = in_.integer("0 for text or 1 for binary", 0, 1) == 1;
    in_.integer("8 bytes in a real number", 8, 8);
    in_.rest_of_line();
    if (!binary) return;
    const std::string_view one = in_.bytes(sizeof(std::int32_t), "the integer 1 in 4 bytes");
    const bool swapped = load<std::int32_t>(one.data(), false) != 1;
    if (load<std::int32_t>(one.data(), swapped) != 1) in_.fail(one, "the integer 1 in 4 bytes");
    numbers_.set_binary(swapped);
  }

  void end_section(const std::string& section) {
    const std::string end =
        section == "$NOD" || section == "$ELM" ? "$END" + section.substr(1) : "$End" + section.substr(1);
    const std::string_view found = in_.token(end);
    if (found != end) in_.fail(found, end);
  }

  std::int64_t count_8(std::string_view expected) { return numbers_.count<std::uint64_t>(expected); }
  int any_4(std::string_view expected) { return numbers_.any<std::int32_t>(expected); }

  /// Points, curves, surfaces and volumes; parts that a partition made name what they are parts of.
  void read_entities(bool partitioned) {
    in_.rest_of_line();
    if (partitioned) {
      count_8("the number of partitions");
      for (std::int64_t ghosts = count_8("the number of ghost entities"); ghosts > 0; --ghosts)
        for (int k = 0; k < 2; ++k) any_4("a ghost entity");
    }
    std::array<std::int64_t, 4> counts{};
    for (std::int64_t& count : counts) count = count_8("the number of entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i)
        read_entity(dimension, partitioned);
  }

  /// A point has one place and bounds nothing, others have a box; in version 4.0 points have one, too.
  void read_entity(int dimension, bool partitioned) {
    const EntityName name{dimension, any_4("the tag of an entity")};
    Entity entity;
    entity.whole = name;
    if (partitioned) {
      const int parent_dimension = any_4("the dimension of an entity");
      const int parent = any_4("the tag of an entity");
      if (parent_dimension == dimension) entity.whole = {dimension, parent};
      for (std::int64_t k = count_8("the number of partitions"); k > 0; --k) any_4("the tag of a partition");
    }
    const bool is_place = dimension == 0 && version_ == Version::v41;
    for (int k = 0; k < (is_place ? 3 : 6); ++k) numbers_.real("a coordinate");
    entity.groups = static_cast<int>(count_8("the number of physical groups"));
    for (int k = 0; k < entity.groups; ++k) {
      // Its sign says how the entity is oriented in the group.
      const int group = std::abs(numbers_.any_but_least("the tag of a physical group"));
      if (k == 0) entity.group = group;
    }
    if (dimension > 0)
      for (std::int64_t k = count_8("the number of bounding entities"); k > 0; --k)
        any_4("the tag of an entity");
    entities_[name] = entity;
  }

  void read_nodes(bool parametric) {
    if (!soup_.points.empty()) in_.fail("$Nodes", "only one such section");
    if (is_4()) {
      read_nodes_4();
    } else {
      read_nodes_2(parametric);
    }
    index_ = TagIndex(soup_.point_labels.numbers);
    if (const auto tag = index_.repeated())
      in_.fail("$EndNodes", "nodes of different tags, but several have the tag " + std::to_string(*tag));
  }

  void read_nodes_2(bool parametric) {
    const std::int64_t count = in_.integer("the number of nodes", 0, most_elements);
    in_.rest_of_line();
    soup_.points.reserve(in_.believable(count, shortest_gmsh_line));
    for (std::int64_t i = 0; i < count; ++i) {
      const int tag = numbers_.tag<std::int32_t>("the tag of a node");
      note(soup_.point_labels, tag, in_.line());
      soup_.points.push_back(numbers_.point());
      if (!parametric) continue;
      const int dimension = any_4("the dimension of an entity");
      any_4("the tag of an entity");
      pass_over_parameters(dimension == 1 || dimension == 2 ? dimension : 0);
    }
  }

  /// In text, whatever stands on the line.
  void pass_over_parameters(std::int64_t count) {
    if (numbers_.is_binary()) {
      for (; count > 0; --count) numbers_.real("a parameter");
    } else {
      while (in_.line_goes_on()) in_.token("");
    }
  }

  void read_nodes_4() {
    in_.rest_of_line();
    const std::int64_t blocks = count_8("the number of blocks");
    const std::int64_t count = count_8("the number of nodes");
    for (int i = 0; version_ == Version::v41 && i < 2; ++i) count_8("the tag of a node");
    soup_.points.reserve(in_.believable(count, shortest_gmsh_line));
    for (std::int64_t b = 0; b < blocks; ++b) read_node_block();
    if (static_cast<std::int64_t>(soup_.points.size()) != count)
      in_.fail(std::to_string(soup_.points.size()) + " nodes", std::to_string(count) + " as announced");
  }

  /// Dimension and tag; version 4.0 has them the other way round.
  EntityName read_entity_name() {
    if (version_ == Version::v40) {
      const int tag = any_4("the tag of an entity");
      return {static_cast<int>(numbers_.integer<std::int32_t>("the dimension of an entity", 0, 3)), tag};
    }
    const auto dimension =
        static_cast<int>(numbers_.integer<std::int32_t>("the dimension of an entity", 0, 3));
    return {dimension, any_4("the tag of an entity")};
  }

  void read_node_block() {
    const int dimension = read_entity_name().first;
    const bool parametric = numbers_.integer<std::int32_t>("0 or 1 for parametric", 0, 1) == 1;
    const std::int64_t count = count_8("the number of nodes in the block");
    if (version_ == Version::v41)
      for (std::int64_t i = 0; i < count; ++i) {
        const int tag = numbers_.tag<std::uint64_t>("the tag of a node");
        note(soup_.point_labels, tag, in_.line());
      }
    for (std::int64_t i = 0; i < count; ++i) {
      if (version_ == Version::v40) {
        const int tag = numbers_.tag<std::int32_t>("the tag of a node");
        note(soup_.point_labels, tag, in_.line());
      }
      soup_.points.push_back(numbers_.point());
      if (parametric) pass_over_parameters(dimension);
    }
  }

  void read_elements() {
    if (is_4()) {
      read_elements_4();
    } else {
      read_elements_2();
    }
  }

  /// Text has elements one by one with their type, binary has them in blocks of one type and number of tags.
  /// Version 1 has always two tags, and then the number of nodes.
  void read_elements_2() {
    const std::int64_t count = in_.integer("the number of elements", 0, most_elements);
    in_.rest_of_line();
    for (std::int64_t done = 0; done < count;) {
      const bool text = !numbers_.is_binary();
      int number = text ? numbers_.tag<std::int32_t>("the tag of an element") : 0;
      const GmshType type = read_type();
      const std::int64_t in_block =
          text ? 1 : numbers_.integer<std::int32_t>("the elements in the block", 1, count - done);
      const std::int64_t tags = version_ == Version::v1
                                    ? 2
                                    : numbers_.integer<std::int32_t>("the number of tags", 0, most_elements);
      for (std::int64_t i = 0; i < in_block; ++i, ++done) {
        if (!text) number = numbers_.tag<std::int32_t>("the tag of an element");
        Origin origin{0, 0};
        for (std::int64_t k = 0; k < tags; ++k) {
          const int tag = numbers_.any_but_least("a tag");
          if (k == 0) origin.group = std::abs(tag);
          if (k == 1) origin.entity = tag;
          if (k == 2) soup_.passed_over.note("partition of an element");
        }
        if (version_ == Version::v1) in_.integer("the number of nodes", type.nodes, type.nodes);
        read_element<std::int32_t>(type, number, origins_.number(origin));
      }
    }
  }

  void read_elements_4() {
    in_.rest_of_line();
    const std::int64_t blocks = count_8("the number of blocks");
    count_8("the number of elements");
    for (int i = 0; version_ == Version::v41 && i < 2; ++i) count_8("the tag of an element");
    for (std::int64_t b = 0; b < blocks; ++b) {
      const EntityName name = read_entity_name();
      const GmshType type = read_type();
      const std::int64_t count = count_8("the number of elements in the block");
      const int origin = origin_of(name, type, count);
      if (type.type == gmsh_tetrahedron)
        soup_.tetrahedra.reserve(soup_.tetrahedra.size() + in_.believable(count, shortest_gmsh_line));
      for (std::int64_t i = 0; i < count; ++i) {
        if (version_ == Version::v41)
          read_element<std::uint64_t>(type, numbers_.tag<std::uint64_t>("the tag of an element"), origin);
        else
          read_element<std::int32_t>(type, numbers_.tag<std::int32_t>("the tag of an element"), origin);
      }
    }
  }

  int origin_of(const EntityName& name, const GmshType& type, std::int64_t count) {
    const auto known = entities_.find(name);
    if (known == entities_.end()) return origins_.number({0, name.second});
    Entity entity = known->second;
    if (entity.group == 0)
      if (const auto whole = entities_.find(entity.whole); whole != entities_.end()) {
        entity.group = whole->second.group;
        entity.groups = whole->second.groups;
      }
    if (dimension_of(type.shape) >= 2) {
      if (entity.groups > 1)
        soup_.passed_over.note("further physical group of an element", count * (entity.groups - 1));
      if (entity.whole != name) soup_.passed_over.note("partition of an element", count);
    }
    return origins_.number({entity.group, entity.whole.second});
  }

  GmshType read_type() {
    const int type = static_cast<int>(numbers_.integer<std::int32_t>("an element type", 1, most_elements));
    const auto found = gmsh_type(type);
    if (!found) in_.fail(std::to_string(type), "an element type of Gmsh up to 31");
    return *found;
  }

  template <class Stored>
  void read_element(const GmshType& type, int number, int origin) {
    const int line = in_.line();
    nodes_.clear();
    for (int i = 0; i < type.nodes; ++i) {
      const int tag = numbers_.tag<Stored>("the tag of a node");
      const std::optional<int> index = index_.find(tag);
      if (!index) in_.fail(std::to_string(tag), "the tag of a node");
      nodes_.push_back(*index);
    }
    cells_.add(type.shape, nodes_, {number, line, origin});
  }

  MeshCursor in_;
  GmshNumbers numbers_;
  Soup soup_;
  Cells cells_{soup_};
  TagIndex index_{Runs()};
  std::map<EntityName, Entity> entities_;
  Origins origins_;
  std::vector<int> nodes_;
  Version version_ = Version::v2;
  bool has_format_ = false;
};

} // namespace

Soup read_gmsh(std::string_view text, const std::string& source) {
  return GmshReader(text, source).read();
}

} // namespace tetrarch::format
