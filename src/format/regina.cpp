// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/regina.hpp"

#include "gluing_table.hpp"
#include "inflate.hpp"
#include "xml.hpp"

#include "tetrarch/format/text.hpp"

#include <algorithm>

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

std::optional<Perm4> perm_of_images(std::int64_t code) {
  if (code < 0 || code > 255) return std::nullopt;
  std::string digits;
  for (int v = 0; v < 4; ++v) digits += static_cast<char>('0' + (code >> (2 * v) & 3));
  return parse_perm(digits);
}

/// The places where 3-manifold triangulations stand: <tri dim="3"> or <tetrahedra>.
class Finder : public pugi::xml_tree_walker {
public:
  bool for_each(pugi::xml_node& node) override {
    const Tag name = node.name();
    if (name == "tetrahedra" || (name == "tri" && Tag(node.attribute("dim").value()) == "3"))
      found_.push_back(node);
    return true;
  }
  const std::vector<pugi::xml_node>& found() const { return found_; }

private:
  std::vector<pugi::xml_node> found_;
};

class ReginaReader {
public:
  ReginaReader(std::string_view text, std::string source) : text_(text), source_(std::move(source)) {}

  Document read() const {
    pugi::xml_document document = parse_xml(text_, source_);
    const Tag root = document.document_element().name();
    if (root != "regina" && root != "reginadata")
      throw InputError(Place{source_, 0}, found_expected(root, "regina or reginadata, a Regina data file"));
    Finder finder;
    document.traverse(finder);
    if (finder.found().size() != 1) fail_count(finder.found());
    const pugi::xml_node node = finder.found().front();
    return document_of(triangulation(node), clean_line(label(node)));
  }

private:
  Place place(const pugi::xml_node& node) const {
    const auto offset =
        std::clamp<std::ptrdiff_t>(node.offset_debug(), 0, static_cast<std::ptrdiff_t>(text_.size()));
    return {source_, 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + offset, '\n'))};
  }

  static std::string label(const pugi::xml_node& node) {
    const pugi::xml_node packet = Tag(node.name()) == "tri" ? node : node.parent();
    return packet.attribute("label").value();
  }

  [[noreturn]] void fail_count(const std::vector<pugi::xml_node>& found) const {
    constexpr std::size_t listed = 5;
    std::string what =
        "found " + (found.empty() ? "no" : std::to_string(found.size())) + " triangulations of 3-manifolds";
    for (std::size_t i = 0; i < std::min(found.size(), listed); ++i)
      what += (i == 0 ? " (" : ", ") + in_quotes(label(found[i]));
    if (!found.empty()) what += found.size() > listed ? ", ...)" : ")";
    throw InputError(Place{source_, 0}, what + ", expected one");
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
    const auto next = [&](const char* expected) {
      const std::string_view token = in.peek();
      if (!token.empty()) in.token("");
      const std::optional<std::int64_t> value = parse_integer(token);
      if (!value || *value < -1 || *value >= most_tetrahedra)
        throw InputError(place(node), found_expected(token, expected));
      return *value;
    };
    for (Gluing& g : faces) {
      g.tet = static_cast<int>(next("a neighbor"));
      const std::int64_t code = next("a permutation");
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

Document read_regina(std::string_view text, const std::string& source) {
  if (text.substr(0, gzip_mark.size()) != gzip_mark) return ReginaReader(text, source).read();
  const std::string plain = inflate(text, longest_file, {source, 0});
  return ReginaReader(plain, source).read();
}

} // namespace tetrarch::format
