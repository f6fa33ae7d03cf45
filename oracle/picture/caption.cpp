#include "oracle/picture/caption.hpp"

#include <map>
#include <optional>

#include <fmt/format.h>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::picture {
namespace {

using Fields = std::map<std::string, std::string, std::less<>>;

std::string noun(const Simplex& simplex) {
  const bool has_name = !simplex.empty() && simplex.size() <= 4;
  return report::simplices_noun(has_name ? static_cast<int>(simplex.size()) - 1 : 4, 1);
}

Fields fields_of(const Witness& witness, const Mesh& mesh) {
  const report::NamedCells named = report::named_cells(witness, mesh);
  const bool is_flat = mesh.dimension() == 2;
  Fields fields = {{"count", std::to_string(named.simplices.size())},
                   {"ball", is_flat ? "circle" : "ball"},
                   {"flat", is_flat ? "on one line" : "in one plane"}};
  const auto with_noun = [](const Simplex& simplex) {
    return noun(simplex) + " " + report::joined(simplex);
  };
  if (!named.simplices.empty()) {
    const Simplex& first = named.simplices[0];
    fields["first"] = report::joined(first);
    fields["simplex"] = with_noun(first);
    fields["noun"] = noun(first);
    fields["corners"] = std::to_string(first.size());
  }
  if (named.simplices.size() > 1) {
    fields["second"] = report::joined(named.simplices[1]);
    fields["other simplex"] = with_noun(named.simplices[1]);
  }
  if (named.face) {
    fields["face"] = named.face->empty() ? "the empty face" : with_noun(*named.face);
  }
  if (!witness.vertices.empty()) {
    Simplex own;
    for (const Vertex v : witness.vertices) own.push_back(mesh.label(v));
    fields["vertices"] = report::joined(own);
  }
  for (const NamedValue& value : witness.values) {
    if (value.name == "vertices expected") fields["expected"] = to_string(value.value);
  }
  if (witness.measured) {
    fields["measured"] = measure_text(witness.measured->measure, witness.measured->value);
    fields["required"] = witness.measured->required;
  }
  if (witness.nearest) {
    fields["nearest"] = std::to_string(mesh.label(witness.nearest->vertex));
    fields["distance"] = square_root_to_decimal(witness.nearest->squared_distance);
  }
  return fields;
}

// None if a field is lacking.
std::optional<std::string> filled(std::string_view sentence, const Fields& fields) {
  std::string text;
  while (!sentence.empty()) {
    const std::size_t plain = std::min(sentence.find_first_of("{["), sentence.size());
    text += sentence.substr(0, plain);
    sentence.remove_prefix(plain);
    if (sentence.empty()) break;
    const std::size_t end = sentence.find(sentence.front() == '{' ? '}' : ']');
    const std::string_view inside = sentence.substr(1, end - 1);
    if (sentence.front() == '[') {
      text += filled(inside, fields).value_or("");
    } else {
      const auto found = fields.find(inside);
      if (found == fields.end()) return std::nullopt;
      text += found->second;
    }
    sentence.remove_prefix(end + 1);
  }
  return text;
}

}  // namespace

std::string caption(const Violation& violation, const Mesh& mesh) {
  const RuleEntry& rule = entry(violation.rule);
  const auto sentence = filled(rule.sentence, fields_of(violation.witness, mesh));
  return sentence.value_or(fmt::format("{}.", rule.meaning));
}

std::string_view name(Mark mark) {
  switch (mark) {
    case Mark::kCells:
      return "cells";
    case Mark::kEdges:
      return "edges";
    case Mark::kNoBall:
      return "no-ball";
    case Mark::kOrder:
      return "order";
    case Mark::kCommonPart:
      return "common-part";
    case Mark::kHole:
      return "hole";
    case Mark::kNearest:
      return "nearest";
    case Mark::kCuts:
      return "cuts";
    case Mark::kBareSide:
      return "bare-side";
    case Mark::kBall:
      return "ball";
    case Mark::kBallAndSight:
      return "ball-and-sight";
    case Mark::kOrthogonalBall:
      return "orthogonal-ball";
    case Mark::kSmallestBall:
      return "smallest-ball";
  }
  return "";
}

}  // namespace circumspect::picture
