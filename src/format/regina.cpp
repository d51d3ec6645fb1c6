// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/regina.hpp"

#include "gluing_table.hpp"
#include "inflate.hpp"
#include "xml.hpp"

#include "tetrarch/format/snappea.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace tetrarch::format {
namespace {

using Tag = std::string_view;

/// One generation of the format: how a triangulation and its tetrahedra are called, and its permutations.
struct Generation {
  const char* size; ///< the attribute that announces how many tetrahedra
  const char* tetrahedron;
  bool by_number; ///< permutations by Regina's number, else by their images
};
constexpr Generation second{"ntet", "tet", false};
constexpr Generation third{"size", "simplex", true};

std::optional<Perm4> perm_of_number(std::int64_t number) {
  if (number < 0 || number >= Perm4::count) return std::nullopt;
  const Perm4 same = Perm4::from_rank(static_cast<int>(number));
  const bool parity_fits = (same.sign() > 0) == (number % 2 == 0);
  return parity_fits ? same : Perm4::from_rank(static_cast<int>(number ^ 1));
}

/// A byte of four images, two bits each; the oldest files write it as a signed one.
std::optional<Perm4> perm_of_images(std::int64_t code) {
  if (code < std::numeric_limits<std::int8_t>::min() || code > std::numeric_limits<std::uint8_t>::max())
    return std::nullopt;
  std::string digits;
  for (int v = 0; v < 4; ++v) digits += static_cast<char>('0' + (code >> (2 * v) & 3));
  return parse_perm(digits);
}

/// How a kind of packet is called: in the third generation by its tag, in the second by its type.
struct PacketKind {
  Tag tag;
  Tag type;
  Tag what;
};
constexpr std::array packet_kinds{
    PacketKind{"container", "Container", ""}, // holds other packets, and nothing else
    PacketKind{"textdata", "Text", "text packet"},
    PacketKind{"script", "Script", "script packet"},
    PacketKind{"pdf", "PDF", "PDF packet"},
    PacketKind{"attachment", "Attachment", "attachment packet"},
    PacketKind{"surfaces", "Normal Surface List", "list of normal surfaces"},
    PacketKind{"hypersurfaces", "Normal Hypersurface List", "list of normal hypersurfaces"},
    PacketKind{"filtercomb", "Combination Surface Filter", "surface filter"},
    PacketKind{"filterprop", "Property-Based Surface Filter", "surface filter"},
    PacketKind{"filter", "Surface Filter", "surface filter"},
    PacketKind{"angles", "Angle Structure List", "list of angle structures"},
    PacketKind{"link", "Link", "link"},
    PacketKind{"tri", "", "triangulation of another dimension"},
};

/// What the ledger calls a packet; empty for a container.
std::string what_of(const pugi::xml_node& node) {
  const bool typed = Tag(node.name()) == "packet";
  const Tag name = typed ? node.attribute("type").value() : node.name();
  if (typed && name.find("-Manifold Triangulation") != Tag::npos) return "triangulation of another dimension";
  for (const PacketKind& kind : packet_kinds)
    if (name == (typed ? kind.type : kind.tag)) return std::string(kind.what);
  return clean_line(name) + " packet";
}

/// Sorts the packets of a file: those that hold a triangulation of a 3-manifold, and the others.
class Finder : public pugi::xml_tree_walker {
public:
  bool for_each(pugi::xml_node& node) override {
    const Tag name = node.name();
    const Tag above = node.parent().name();
    const bool gluings = name == "tetrahedra" || (name == "tri" && Tag(node.attribute("dim").value()) == "3");
    if (gluings || name == "snappea" || name == "snappeadata")
      found_.push_back(node);
    else if (name == "packet" ? !node.child("tetrahedra") && !node.child("snappea")
                              : !node.attribute("label").empty() && above != "packet")
      others_.note(what_of(node), what_of(node).empty() ? 0 : 1);
    return true;
  }
  const std::vector<pugi::xml_node>& found() const { return found_; }
  const Ledger& others() const { return others_; }

private:
  std::vector<pugi::xml_node> found_;
  Ledger others_;
};

class ReginaReader {
public:
  ReginaReader(std::string_view text, std::string source) : text_(text), source_(std::move(source)) {}

  Collection read() const {
    pugi::xml_document document = parse_xml(text_, source_, pugi::encoding_auto);
    const Tag root = document.document_element().name();
    if (root != "regina" && root != "reginadata")
      throw InputError(Place{source_, 0}, found_expected(root, "regina or reginadata, a Regina data file"));
    Finder finder;
    document.traverse(finder);
    Collection packets{{}, finder.others()};
    packets.elements.reserve(finder.found().size());
    for (const pugi::xml_node& node : finder.found()) packets.elements.push_back(element(node));
    return packets;
  }

private:
  Place place(const pugi::xml_node& node) const {
    const std::ptrdiff_t offset = std::max<std::ptrdiff_t>(node.offset_debug(), 0);
    return {source_, line_of(text_, static_cast<std::size_t>(offset))};
  }

  Element element(const pugi::xml_node& node) const {
    const Tag tag = node.name();
    const pugi::xml_node packet = tag == "tri" || tag == "snappeadata" ? node : node.parent();
    Element element{clean_line(packet.attribute("label").value()), {}, {}};
    try {
      if (tag == "snappea" || tag == "snappeadata")
        element.document = snappea(node, element.name);
      else
        element.document.triangulation = triangulation(node);
      if (!element.name.empty()) element.document.name = element.name;
    } catch (const InputError& e) {
      element.error = e;
    }
    return element;
  }

  /// A fault is placed twice: in the file, and in the packet, whose lines count from its own first one.
  Document snappea(const pugi::xml_node& node, const std::string& label) const {
    try {
      return read_snappea(node.text().get(), "SnapPea packet " + in_quotes(label));
    } catch (const InputError& e) {
      throw InputError(place(node), e.what());
    }
  }

  Triangulation triangulation(const pugi::xml_node& node) const {
    const Generation& generation = Tag(node.name()) == "tri" ? third : second;
    const Tag perm = node.attribute("perm").value();
    if (generation.by_number && perm != "index")
      throw InputError(place(node), found_expected(perm, "the permutations by their index"));
    GluingTable table;
    std::vector<pugi::xml_node> tetrahedra;
    for (const pugi::xml_node& child : node.children(generation.tetrahedron)) tetrahedra.push_back(child);
    const Tag announced = node.attribute(generation.size).value();
    const std::string count = std::to_string(tetrahedra.size());
    if (announced != count)
      throw InputError(place(node), "found " + count + " tetrahedra, expected " + in_quotes(announced));
    for (const pugi::xml_node& tetrahedron : tetrahedra) table.push_back(gluings(tetrahedron, generation));
    if (const std::optional<GluingFault> fault = find_fault(table))
      throw InputError(place(tetrahedra[static_cast<std::size_t>(fault->at.tet)]), fault->what);
    return build(table);
  }

  std::array<Gluing, 4> gluings(const pugi::xml_node& node, const Generation& generation) const {
    std::array<Gluing, 4> faces{};
    TextCursor in(node.text().get(), source_);
    const auto next = [&](const char* expected, std::int64_t least) {
      const std::string_view token = in.peek();
      if (!token.empty()) in.token("");
      const std::optional<std::int64_t> value = parse_integer(token);
      if (!value || *value < least || *value >= most_tetrahedra)
        throw InputError(place(node), found_expected(token, expected));
      return *value;
    };
    for (Gluing& g : faces) {
      g.tet = static_cast<int>(next("a neighbor", -1));
      const std::int64_t code = next("a permutation", std::numeric_limits<std::int8_t>::min());
      if (g.tet < 0) continue;
      const std::optional<Perm4> perm = generation.by_number ? perm_of_number(code) : perm_of_images(code);
      if (!perm) throw InputError(place(node), found_expected(std::to_string(code), "a permutation"));
      g.perm = *perm;
    }
    if (!in.at_end()) throw InputError(place(node), found_expected(in.peek(), "four neighbors"));
    return faces;
  }

  static constexpr std::int64_t most_tetrahedra = std::int64_t{1} << 30;

  std::string_view text_;
  std::string source_;
};

} // namespace

Collection read_regina_packets(std::string_view text, const std::string& source) {
  if (!text.starts_with(gzip_mark)) return ReginaReader(text, source).read();
  const Inflated plain = inflate(text, most_inflated(text.size()), {source, 0});
  Collection packets = ReginaReader(plain.data, source).read();
  packets.passed_over.note("byte after the compressed data", static_cast<std::int64_t>(plain.left));
  return packets;
}

Document read_regina(std::string_view text, const std::string& source) {
  return the_only(read_regina_packets(text, source), source);
}

} // namespace tetrarch::format
