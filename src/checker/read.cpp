// SPDX-License-Identifier: GPL-2.0-or-later
#include "gluing.hpp"

#include "tetrarch/core/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <utility>

namespace tetrarch::checker {
namespace {

using Json = nlohmann::json;

constexpr int most_bits = 8192;
constexpr std::size_t longest_number = 1'000'000;
constexpr int deepest_nesting = 8;

/// Reads one certificate; complains in the name of `source`.
class Reader {
public:
  explicit Reader(std::string source) : source_(std::move(source)) {}

  Certificate read(std::string_view text) {
    const Json json = parsed(text);
    if (json.is_object() && json.contains("cells"))
      require_members(json, "the certificate",
                      {"format", "version", "gluings", "bits", "radius", "edges", "claims", "cells"});
    else
      require_members(json, "the certificate",
                      {"format", "version", "gluings", "bits", "radius", "edges", "claims"});
    if (json["format"] != "tetrarch-certificate") fail("\"format\" is not \"tetrarch-certificate\"");
    if (json["version"] != 1) fail("\"version\" is not 1");
    Certificate found;
    read_gluings(json["gluings"], found);
    found.bits = integer(json["bits"], "bits", 2, most_bits);
    found.radius = exact(json["radius"], "radius");
    read_edges(json["edges"], found);
    read_claims(json["claims"], found);
    if (json.contains("cells")) read_cells(json["cells"], found);
    return found;
  }

private:
  [[noreturn]] void fail(const std::string& message) const { throw InputError(Place{source_, 0}, message); }

  Json parsed(std::string_view text) const {
    std::vector<std::set<std::string>> keys; // of the objects that are open
    bool repeated = false;
    Json json = Json::parse(
        text,
        [&](int depth, Json::parse_event_t event, Json& item) {
          if (depth > deepest_nesting) fail("brackets are nested too deeply");
          if (event == Json::parse_event_t::object_start) keys.emplace_back();
          if (event == Json::parse_event_t::key)
            repeated |= !keys.back().insert(item.get<std::string>()).second;
          if (event == Json::parse_event_t::object_end) keys.pop_back();
          return true;
        },
        false);
    if (json.is_discarded()) fail("this is no JSON text");
    if (repeated) fail("an object has two members of the same name");
    return json;
  }

  void require_members(const Json& json, const std::string& what,
                       std::initializer_list<const char*> names) const {
    if (!json.is_object()) fail(what + " is not an object");
    for (const char* name : names)
      if (!json.contains(name)) fail(what + " has no member \"" + name + "\"");
    if (json.size() != names.size()) fail(what + " has a member that no certificate has");
  }

  int integer(const Json& json, const std::string& what, int least, int most) const {
    if (!json.is_number_integer() || json < least || json > most)
      fail("\"" + what + "\": expected a whole number from " + std::to_string(least) + " to " +
           std::to_string(most) + ", found " + in_quotes(json.dump()));
    return json.get<int>();
  }

  bool truth(const Json& json, const std::string& what) const {
    if (!json.is_boolean()) fail("\"" + what + "\": expected true or false, found " + in_quotes(json.dump()));
    return json.get<bool>();
  }

  std::string text(const Json& json, const std::string& what) const {
    if (!json.is_string()) fail("\"" + what + "\": expected a text, found " + in_quotes(json.dump()));
    auto found = json.get<std::string>();
    if (found.size() > longest_number) fail("\"" + what + "\": a number of this length is refused");
    return found;
  }

  /// An integer times a power of two: "-0x1ap-4".
  std::string exact(const Json& json, const std::string& what) const {
    std::string found = text(json, what);
    std::string_view rest = found;
    if (rest.starts_with('-')) rest.remove_prefix(1);
    const std::size_t p = rest.find('p');
    if (!rest.starts_with("0x") || p == std::string_view::npos || p < 3 ||
        rest.substr(2, p - 2).find_first_not_of("0123456789abcdef") != std::string_view::npos ||
        !is_exponent(rest.substr(p + 1)))
      fail("\"" + what + "\": expected an integer times a power of two like \"0x1ap-4\", found " +
           in_quotes(found));
    return found;
  }

  static bool is_exponent(std::string_view digits) {
    if (digits.starts_with('-')) digits.remove_prefix(1);
    return !digits.empty() && digits.size() <= 8 &&
           digits.find_first_not_of("0123456789") == std::string_view::npos;
  }

  /// A decimal number: "-6.45", "1e-5".
  std::string decimal(const Json& json, const std::string& what) const {
    std::string found = text(json, what);
    std::string_view rest = found;
    if (rest.starts_with('-')) rest.remove_prefix(1);
    const std::size_t e = std::min(rest.find('e'), rest.size());
    const std::string_view digits = rest.substr(0, e);
    std::string_view exponent = rest.substr(std::min(e + 1, rest.size()));
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    const bool good = !digits.empty() && digits.front() != '.' && digits.back() != '.' &&
                      std::count(digits.begin(), digits.end(), '.') <= 1 &&
                      digits.find_first_not_of("0123456789.") == std::string_view::npos &&
                      (e == rest.size() || is_exponent(exponent));
    if (!good) fail("\"" + what + "\": expected a decimal number, found " + in_quotes(found));
    return found;
  }

  FaceGluing gluing(const Json& json, int tets) const {
    if (!json.is_array() || json.size() != 2)
      fail("\"gluings\": expected [tetrahedron, images of 0123], found " + in_quotes(json.dump()));
    FaceGluing found;
    found.tet = integer(json[0], "gluings", 0, tets - 1);
    const std::string images = text(json[1], "gluings");
    std::string sorted = images;
    std::sort(sorted.begin(), sorted.end());
    if (sorted != "0123") fail("\"gluings\": expected a permutation of 0123, found " + in_quotes(images));
    for (int v = 0; v < 4; ++v) found.images[v] = images[v] - '0';
    return found;
  }

  void read_gluings(const Json& json, Certificate& found) const {
    if (!json.is_array() || json.empty()) fail("\"gluings\": expected a list of tetrahedra");
    for (const Json& tet : json) {
      if (!tet.is_array() || tet.size() != 4) fail("\"gluings\": expected four faces of each tetrahedron");
      std::array<FaceGluing, 4> faces;
      for (int f = 0; f < 4; ++f) faces[f] = gluing(tet[f], static_cast<int>(json.size()));
      found.gluings.push_back(faces);
    }
  }

  void read_edges(const Json& json, Certificate& found) const {
    if (!json.is_array()) fail("\"edges\": expected a list");
    for (const Json& entry : json) {
      require_members(entry, "an edge", {"tetrahedron", "edge", "length", "fixed"});
      found.edges.push_back(
          {integer(entry["tetrahedron"], "tetrahedron", 0, static_cast<int>(found.gluings.size()) - 1),
           integer(entry["edge"], "edge", 0, 5), exact(entry["length"], "length"),
           truth(entry["fixed"], "fixed")});
    }
  }

  void read_claims(const Json& json, Certificate& found) const {
    require_members(json, "\"claims\"", {"orientable", "links", "volume"});
    found.orientable = truth(json["orientable"], "orientable");
    if (!json["links"].is_array()) fail("\"links\": expected a list");
    for (const Json& link : json["links"]) found.links.push_back(integer(link, "links", -1'000'000'000, 2));
    if (!json["volume"].is_array() || json["volume"].size() != 2) fail("\"volume\": expected two numbers");
    for (int k = 0; k < 2; ++k) found.volume[k] = decimal(json["volume"][k], "volume");
  }

  void read_cells(const Json& json, Certificate& found) const {
    require_members(json, "\"cells\"", {"cusp_area", "faces"});
    CellClaims& cells = found.cells.emplace();
    if (!json["cusp_area"].is_null()) {
      cells.cusp_area = decimal(json["cusp_area"], "cusp_area");
      if (cells.cusp_area.starts_with('-') ||
          cells.cusp_area.find_first_of("123456789") >= cells.cusp_area.find('e'))
        fail("\"cusp_area\": expected a positive number, found " + in_quotes(cells.cusp_area));
    }
    if (!json["faces"].is_array()) fail("\"faces\": expected a list");
    for (const Json& entry : json["faces"]) {
      require_members(entry, "a face", {"tetrahedron", "face", "flat"});
      CellClaims::Face face;
      face.tet = integer(entry["tetrahedron"], "tetrahedron", 0, static_cast<int>(found.gluings.size()) - 1);
      face.face = integer(entry["face"], "face", 0, 3);
      if (!entry["flat"].is_null()) face.flat = criterion(entry["flat"]);
      cells.faces.push_back(std::move(face));
    }
  }

  std::string criterion(const Json& json) const {
    std::string found = text(json, "flat");
    for (const char* known : {"R", "F", "B", "L", "E"})
      if (found == known) return found;
    fail("\"flat\": expected R, F, B, L, E or null, found " + in_quotes(found));
  }

  std::string source_;
};

} // namespace

Certificate read(std::string_view text, const std::string& source) {
  return Reader(source).read(text);
}

} // namespace tetrarch::checker
