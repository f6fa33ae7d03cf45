// Verdicts for programs. The schema is in docs/json.md.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "kernel/complex/circumball.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::report {

using Json = nlohmann::ordered_json;

// A document as it is printed: UTF-8 on several lines (on one if `indent` is -1), with a line end
// at the end. In its strings, bytes that are not UTF-8 become U+FFFD, and characters that
// on_one_line (oracle/model/printable.hpp) would escape are written as \uNNNN.
std::string document_text(const Json& document, int indent = 2);

// An exact value as {"exact": "1/3", "decimal": "0.3333333333333333"}.
Json value(const Rational& value);

// Exact coordinates as texts: ["1/3", "2"].
Json point(const Point& point);

// Centre and squared radius exactly, and the radius as a correctly rounded decimal.
Json ball(const Ball& ball);

// A witness by the user's indices; `domain` is the domain that it is about.
Json witness(const Witness& witness, const Mesh& mesh, const Domain* domain = nullptr);

// One judged mesh; `domain` is the domain that the claim is about.
Json verdict(const Verdict& verdict, const Mesh& mesh, const std::string& mesh_name, check::By by,
             const Domain* domain = nullptr);

}  // namespace circumspect::report
