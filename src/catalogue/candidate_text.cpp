// SPDX-License-Identifier: GPL-2.0-or-later
#include "candidate.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

namespace tetrarch::catalogue::detail {
namespace {

using Json = nlohmann::ordered_json;
using Structure = Candidate::Structure;

constexpr std::array<std::string_view, 4> structures{"here", "elsewhere", "none", "unknown"};

Json json_of(const Candidate& c) {
  Json item{{"signature", c.signature}, {"structure", structures[static_cast<std::size_t>(c.structure)]}};
  if (!c.reason.empty()) item["reason"] = c.reason;
  if (!c.evidence.empty()) item["evidence"] = c.evidence;
  if (c.flat) item["flat"] = true;
  if (c.proofs.bits > 0) item["bits"] = c.proofs.bits;
  if (c.proofs.bits > 0) item["width"] = c.proofs.width;
  if (!c.proofs.cells.empty()) item["proved"] = c.proofs.cells;
  if (!c.proofs.why_not.empty()) item["why_not"] = c.proofs.why_not;
  if (!c.has_cells) return item;
  item["tetrahedra"] = c.manifold.tetrahedra;
  if (!c.manifold.orientable) item["orientable"] = false;
  item["manifold"] = Json::parse(json_text(c.manifold));
  return item;
}

Candidate candidate_from(const Json& item) {
  Candidate c;
  c.signature = item.at("signature");
  const auto* const name =
      std::find(structures.begin(), structures.end(), item.at("structure").get<std::string>());
  if (name == structures.end()) throw InputError("this is no outcome");
  c.structure = static_cast<Structure>(name - structures.begin());
  c.reason = item.value("reason", "");
  c.evidence = item.value("evidence", "");
  c.flat = item.value("flat", false);
  c.proofs.bits = item.value("bits", 0);
  c.proofs.width = item.value("width", 0.0);
  c.proofs.cells = item.value("proved", "");
  c.proofs.why_not = item.value("why_not", "");
  c.has_cells = item.contains("manifold");
  if (c.has_cells)
    c.manifold = read_manifold(item.at("manifold").dump(),
                               {item.at("tetrahedra").get<int>(), item.value("orientable", true)});
  return c;
}

} // namespace

std::string unit_text(std::span<const Candidate> unit) {
  Json list = Json::array();
  for (const Candidate& c : unit) list.push_back(json_of(c));
  return list.dump();
}

bool leaves_unknown(const std::string& text) {
  return text.find("\"structure\":\"unknown\"") != std::string::npos;
}

std::optional<std::vector<Candidate>> read_unit(const std::string& text,
                                                std::span<const std::string> signatures) {
  std::vector<Candidate> unit;
  try {
    for (const Json& item : Json::parse(text)) unit.push_back(candidate_from(item));
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
  const bool same =
      std::equal(unit.begin(), unit.end(), signatures.begin(), signatures.end(),
                 [](const Candidate& c, const std::string& signature) { return c.signature == signature; });
  return same ? std::optional(std::move(unit)) : std::nullopt;
}

} // namespace tetrarch::catalogue::detail
