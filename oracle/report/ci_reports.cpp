#include "oracle/report/ci_reports.hpp"

#include <cctype>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "oracle/model/printable.hpp"

namespace circumspect::report {
namespace {

std::string uri_of(const std::string& path) {
  constexpr std::string_view kPlain = "-._~/+";
  std::string text = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = std::isalnum(byte) != 0 || kPlain.find(c) != kPlain.npos;
    text += is_plain ? std::string(1, c) : fmt::format("%{:02X}", unsigned{byte});
  }
  return text;
}

// The file that a result is about.
std::string place_of(const Json& result) {
  for (const char* const key : {"mesh", "domain"}) {
    if (result.contains(key) && result[key].is_string()) return result[key].get<std::string>();
  }
  return "-";
}

// "; simplex 1 2 3 and 2 3 4; vertex 5"
std::string where(const Json& violation) {
  std::string cells;
  for (const Json& simplex : violation["simplices"]) {
    cells += cells.empty() ? "; simplex" : " and";
    for (const Json& vertex : simplex) cells += " " + vertex.dump();
  }
  for (const Json& vertex : violation["vertices"]) cells += "; vertex " + vertex.dump();
  return cells;
}

// What is wrong, and after the rules what may be the cause. Empty if nothing is wrong.
std::vector<SarifResult> faults_of(const Json& result) {
  const std::string path = place_of(result);
  for (const auto& [key, rule] : {std::pair{"error", "input"}, {"undecided", "undecided"}}) {
    if (result.contains(key)) return {{rule, result[key].get<std::string>(), path}};
  }
  std::vector<SarifResult> faults;
  std::set<std::string> shown;
  for (const Json& violation : result.value("violations", Json::array())) {
    const auto rule = violation["rule"].get<std::string>();
    shown.insert(rule);
    faults.push_back({rule, violation["meaning"].get<std::string>() + where(violation), path});
  }
  for (const Json& counted : result.value("rules", Json::array())) {
    const auto rule = counted["rule"].get<std::string>();
    if (shown.contains(rule)) continue;
    faults.push_back({rule, counted["count"].dump() + " times", path});
  }
  for (const Json& cause : result.value("causes", Json::array())) {
    faults.push_back({"cause." + cause["cause"].get<std::string>(),
                      fmt::format("{} (explains {} of {})", cause["text"].get<std::string>(),
                                  cause["explains"].dump(), cause["of"].dump()),
                      path, true});
  }
  return faults;
}

}  // namespace

// XML has no way to say a control character, nor bytes that are no UTF-8: those have been written
// otherwise.
std::string for_xml(const std::string& text) {
  std::string result;
  for (const char c : on_lines(text)) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

Json sarif_document(const std::vector<SarifResult>& results, const std::string& version) {
  std::set<std::string> ids;
  Json listed = Json::array();
  for (const SarifResult& result : results) {
    ids.insert(result.rule);
    const Json place = {{"uri", uri_of(result.path)}};
    listed.push_back(
        {{"ruleId", result.rule},
         {"level", result.is_note ? "note" : "error"},
         {"message", {{"text", on_lines(result.text)}}},
         {"locations", Json::array({{{"physicalLocation", {{"artifactLocation", place}}}}})}});
  }
  Json rules = Json::array();
  for (const std::string& id : ids) rules.push_back({{"id", id}});
  const Json driver = {{"name", "circumspect"}, {"version", version}, {"rules", std::move(rules)}};
  const Json run = {{"tool", {{"driver", driver}}}, {"results", std::move(listed)}};
  return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
          {"version", "2.1.0"},
          {"runs", Json::array({run})}};
}

std::string junit_of_check(const Json& results) {
  std::string cases;
  std::size_t failures = 0;
  std::size_t errors = 0;
  for (const Json& result : results) {
    const bool is_judged = result.contains("verdict");
    const std::vector<SarifResult> faults = faults_of(result);
    failures += result.value("verdict", "") == "fails" ? 1 : 0;
    errors += is_judged ? 0 : 1;
    cases += fmt::format("    <testcase classname=\"circumspect.{}\" name=\"{}\"",
                         for_xml(on_one_line(result.value("claim", "input"))),
                         for_xml(on_one_line(place_of(result))));
    if (faults.empty()) {
      cases += "/>\n";
      continue;
    }
    std::string lines;
    for (const SarifResult& fault : faults) lines += fault.rule + ": " + fault.text + "\n";
    cases += fmt::format(">\n      <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n    </testcase>\n",
                         is_judged ? "failure" : "error", for_xml(faults.front().rule),
                         for_xml(lines.substr(0, lines.find('\n'))), for_xml(lines));
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      "  <testsuite name=\"circumspect check\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n{}"
      "  </testsuite>\n</testsuites>\n",
      results.size(), failures, errors, cases);
}

Json sarif_of_check(const Json& results, const std::string& version) {
  std::vector<SarifResult> all;
  for (const Json& result : results) {
    const std::vector<SarifResult> faults = faults_of(result);
    all.insert(all.end(), faults.begin(), faults.end());
  }
  return sarif_document(all, version);
}

}  // namespace circumspect::report
