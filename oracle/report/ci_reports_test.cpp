// Laws of the reports for CI: they say what the JSON document says, no more and no less, and
// whoever reads them gets back every byte.
#include "oracle/report/ci_reports.hpp"

#include <algorithm>
#include <string_view>

#include <doctest/doctest.h>

#include "kernel/complex/circumball.hpp"
#include "kernel/exact/each_once.hpp"

namespace circumspect::report {
namespace {

// Results of `check --format json`: of every kind, with names that XML and URIs have to write
// otherwise.
Json results_of_every_kind() {
  const Json violation = {{"rule", "delaunay.facet-not-local"},
                          {"meaning", "a \"facet\" is not <locally> Delaunay & more"},
                          {"simplices", Json::array({{0, 1, 2}, {1, 2, 3}})},
                          {"vertices", Json::array({3})}};
  const Json counted = {{{"rule", "delaunay.facet-not-local"}, {"count", 7}},
                        {{"rule", "triangulation.overlap"}, {"count", 2}}};
  const Json cause = {
      {"cause", "one-vertex"}, {"text", "all name vertex 3"}, {"explains", 2}, {"of", 9}};
  return {{{"mesh", "good & \"all\" <1>.ele"}, {"claim", "delaunay"}, {"verdict", "holds"}},
          {{"mesh", "100%25 of it/b d.ele"},
           {"claim", "delaunay"},
           {"verdict", "fails"},
           {"violations", Json::array({violation})},
           {"rules", counted},
           {"causes", Json::array({cause})}},
          {{"mesh", "none.ele"}, {"error", "none.ele: expected a file,\nfound none"}},
          {{"domain", "/tmp/d#1?.poly"}, {"error", "expected segments"}},
          {{"mesh", "late.ele"}, {"undecided", "check reached its limit"}}};
}

std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// What a parser of XML makes of a text between tags or quotes.
std::string read_as_xml(std::string text) {
  for (const auto& [entity, byte] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}) {
    const std::string_view whole = entity;
    for (std::size_t at = text.find(whole); at != text.npos; at = text.find(whole, at + 1)) {
      text.replace(at, whole.size(), byte);
    }
  }
  return text;
}

std::string path_of_uri(std::string uri) {
  if (uri.starts_with("file://")) uri.erase(0, 7);
  for (std::size_t at = uri.find('%'); at != uri.npos; at = uri.find('%', at + 1)) {
    uri.replace(at, 3, 1, static_cast<char>(std::stoi(uri.substr(at + 1, 2), nullptr, 16)));
  }
  return uri;
}

// The values of an attribute, in their order.
std::vector<std::string> values_of(const std::string& xml, const std::string& attribute) {
  std::vector<std::string> values;
  const std::string begin = " " + attribute + "=\"";
  for (std::size_t at = xml.find(begin); at != xml.npos; at = xml.find(begin, at + 1)) {
    const std::size_t first = at + begin.size();
    values.push_back(xml.substr(first, xml.find('"', first) - first));
  }
  return values;
}

}  // namespace

TEST_CASE("junit: each result is a test case, with one failure or error if it does not hold") {
  const Json results = results_of_every_kind();
  const std::string xml = junit_of_check(results);
  CHECK(count_of(xml, "<testcase ") == results.size());
  CHECK(count_of(xml, "<failure ") == 1);
  CHECK(count_of(xml, "<error ") == 3);
  CHECK(values_of(xml, "tests").front() == std::to_string(results.size()));
  CHECK(values_of(xml, "failures").front() == "1");
  CHECK(values_of(xml, "errors").front() == "3");
  // No quotation mark ends an attribute too early, and nothing else begins a tag.
  CHECK(count_of(xml, "<") == count_of(xml, ">"));
  std::vector<std::string> names = values_of(xml, "name");
  names.erase(names.begin());  // of the suite
  REQUIRE(names.size() == results.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Json& result = results[i];
    const std::string key = result.contains("mesh") ? "mesh" : "domain";
    CHECK(read_as_xml(names[i]) == result[key].get<std::string>());
  }
  // The message is the first line of what the element says.
  for (const std::string& message : values_of(xml, "message")) {
    CHECK(message.find('\n') == message.npos);
    CHECK(xml.find(">" + message + "\n") != xml.npos);
  }
}

TEST_CASE("sarif: each witness, each further rule, each cause and each error is one result") {
  const Json document = sarif_of_check(results_of_every_kind(), "1");
  const Json& run = document["runs"][0];
  std::vector<std::string> rules;
  for (const Json& result : run["results"]) {
    const auto rule = result["ruleId"].get<std::string>();
    rules.push_back(rule);
    CHECK(result["level"] == (rule.starts_with("cause.") ? "note" : "error"));
  }
  CHECK(rules == std::vector<std::string>{"delaunay.facet-not-local", "triangulation.overlap",
                                          "cause.one-vertex", "input", "input", "undecided"});
  keep_each_once(rules);
  std::vector<std::string> declared;
  for (const Json& rule : run["tool"]["driver"]["rules"]) {
    declared.push_back(rule["id"].get<std::string>());
  }
  CHECK(declared == rules);
}

TEST_CASE("sarif: a path is what its URI says, whatever bytes it has") {
  std::string all;
  for (int byte = 1; byte < 128; ++byte) all += static_cast<char>(byte);
  for (const std::string& path :
       {all, "/" + all, std::string("100%25"), std::string("a%"), std::string("-")}) {
    const Json document = sarif_document({{"rule", "text", path}}, "1");
    const auto uri = document["runs"][0]["results"][0]["locations"][0]["physicalLocation"]
                             ["artifactLocation"]["uri"]
                                 .get<std::string>();
    CHECK(path_of_uri(uri) == path);
    CHECK(uri.find_first_of(" \"<>#?\n") == uri.npos);
  }
}

TEST_CASE("a text comes back from XML as it was") {
  std::string all;
  for (char c = ' '; c < 127; ++c) all += c;
  CHECK(read_as_xml(for_xml(all)) == all);
  CHECK(for_xml(all).find_first_of("<>\"") == std::string::npos);
}

TEST_CASE("json: a document comes back as it was, and has nothing that a terminal obeys") {
  std::string all;
  for (int byte = 1; byte < 128; ++byte) all += static_cast<char>(byte);
  for (const std::string& text : {all, std::string("\xc2\x9b"
                                                   "31m \xc3\xa9 \xe2\x80\xae")}) {
    const std::string written = document_text(Json{{"text", text}});
    CHECK(Json::parse(written)["text"] == text);
    CHECK(std::all_of(written.begin(), written.end(), [](char c) {
      return c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
    }));
    CHECK(written.find("\xc2\x9b") == std::string::npos);
  }
}

TEST_CASE("json: a ball has a radius unless its square is negative") {
  for (const int squared : {-1, 0, 1, 2}) {
    const Json object = ball({{0, 0}, squared});
    CHECK(object.contains("radius_decimal") == (squared >= 0));
    CHECK(object["squared_radius"]["exact"] == std::to_string(squared));
  }
}

}  // namespace circumspect::report
