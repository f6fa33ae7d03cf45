#include "command/campaign/campaign_report.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "command/output/output.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/ci_reports.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {

namespace {

using campaign::Finding;
using campaign::Result;
using Counts = std::map<std::string, std::size_t>;

bool is_no_finding(const std::string& what) {
  return what == "holds" || what == "refused" || what == "skipped" || what == "flaky" ||
         what == "known";
}

std::size_t count_of(const Counts& counts, const std::string& what) {
  const auto found = counts.find(what);
  return found == counts.end() ? 0 : found->second;
}

std::size_t total(const Counts& counts) {
  std::size_t sum = 0;
  for (const auto& [what, count] : counts) sum += count;
  return sum;
}

std::size_t found_in(const Counts& counts) {
  std::size_t sum = 0;
  for (const auto& [what, count] : counts) sum += is_no_finding(what) ? 0 : count;
  return sum;
}

// Is it as write_minimal writes it, as far as anybody here reads it? Whatever has the folder may
// have changed it.
bool are_details(const report::Json& details) {
  const auto is_count = [&details](const char* key) {
    return details.contains(key) && details[key].is_number_unsigned();
  };
  return details.is_object() && details.contains("text") && details["text"].is_string() &&
         is_count("points") && is_count("minimal_points");
}

// What stands in the folder of a finding: the first result of verdict.json; nothing if that cannot
// be read, or is not as it was written.
report::Json details_of(const Finding& finding) {
  constexpr int kDeepest = 64;
  const std::string path = finding.folder + "/verdict.json";
  std::error_code error;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(path, error))) {
    return report::Json::object();
  }
  const formats::Result<formats::Source> source = formats::load(path);
  if (!source) return report::Json::object();
  const auto is_shallow = [](int depth, report::Json::parse_event_t, report::Json&) {
    return depth < kDeepest;
  };
  const report::Json document = report::Json::parse(source->text, is_shallow, false);
  if (!document.is_object() || !document.contains("results")) return report::Json::object();
  const report::Json& results = document["results"];
  const bool is_whole = results.is_array() && !results.empty() && are_details(results.front());
  return is_whole ? results.front() : report::Json::object();
}

std::string finding_text(const Finding& finding) {
  const report::Json details = details_of(finding);
  const std::string text =
      details.value("text", "not made small yet, or its verdict.json is not as it was written");
  std::string sizes;
  if (details.contains("minimal_points")) {
    sizes = fmt::format(", {} made {}{}",
                        report::counted(details["points"].get<std::size_t>(), "point"),
                        details["minimal_points"].get<std::size_t>(),
                        finding.cut_off ? " so far (the same command again goes on)" : "");
  }
  return fmt::format("{}: {}, first case {} of {}{}\n  {}\n  {}/reproduce.sh\n", finding.signature,
                     report::counted(finding.count, "case"), finding.case_number, finding.family,
                     sizes, on_one_line(text), on_one_line(finding.folder));
}

// Where people read about it, from the folder in which the campaign runs if it is there.
std::string place_of(const Finding& finding) {
  std::error_code error;
  const std::filesystem::path whole = finding.folder + "/README.txt";
  const auto from_here = std::filesystem::proximate(whole, error).string();
  return error || from_here.rfind("../", 0) == 0 ? whole.string() : from_here;
}

// With %XX in place of these bytes.
template <class MustBeWritten>
std::string with_percents(const std::string& text, const MustBeWritten& must_be_written) {
  std::string result;
  for (const char c : text) {
    result += must_be_written(c) ? fmt::format("%{:02X}", static_cast<unsigned char>(c))
                                 : std::string(1, c);
  }
  return result;
}

std::string for_annotation(const std::string& text, std::string_view special) {
  return with_percents(text, [special](char c) { return special.find(c) != special.npos; });
}

}  // namespace

std::size_t judged_cases(const Result& result) {
  std::size_t judged = 0;
  for (const auto& [family, counts] : result.statistics) {
    judged += total(counts);
    for (const char* const none : {"refused", "skipped", "flaky"}) {
      judged -= count_of(counts, none);
    }
  }
  return judged;
}

namespace {

// Why cases were skipped and refused, the most frequent reasons first; and what else is not a
// finding.
std::string reasons_text(const Result& result) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (const auto& [what, reasons] : result.reasons) {
    std::vector<std::pair<std::size_t, std::string>> by_count;
    for (const auto& [reason, count] : reasons) by_count.emplace_back(count, reason);
    std::stable_sort(by_count.begin(), by_count.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t i = 0; i < std::min(kShown, by_count.size()); ++i) {
      text += fmt::format("{}: {}, {}\n", what, report::counted(by_count[i].first, "case"),
                          on_one_line(by_count[i].second));
    }
  }
  Counts all;
  for (const auto& [family, counts] : result.statistics) {
    for (const auto& [what, count] : counts) all[what] += count;
  }
  if (all["flaky"] > 0) {
    text += fmt::format("flaky: {}, wrong once, but not when run again three times{}\n",
                        report::counted(all["flaky"], "case"),
                        result.first_flaky.empty() ? "" : "; " + result.first_flaky);
  }
  if (all["known"] > 0) {
    text += fmt::format("known: {}, of signatures in the file of --known\n",
                        report::counted(all["known"], "case"));
  }
  return text;
}

}  // namespace

std::string campaign_text(const Result& result) {
  std::size_t width = 6;
  for (const auto& [family, counts] : result.statistics) width = std::max(width, family.size());
  std::string text = result.doubt.empty() ? "" : "note: " + on_one_line(result.doubt) + "\n";
  text += fmt::format("{:<{}} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "family", width, "cases", "hold",
                      "fail", "refused", "skipped");
  for (const auto& [family, counts] : result.statistics) {
    text += fmt::format("{:<{}} {:>8} {:>8} {:>8} {:>8} {:>8}\n", family, width, total(counts),
                        count_of(counts, "holds"), found_in(counts), count_of(counts, "refused"),
                        count_of(counts, "skipped"));
  }
  const std::size_t now = result.cases - result.cases_before;
  text += fmt::format(
      "{} in {:.1f} s{}\n", report::counted(now, "case"), result.seconds,
      result.cases_before == 0
          ? ""
          : fmt::format(", {} before that", report::counted(result.cases_before, "case")));
  if (result.was_killed_before) {
    text += fmt::format(
        "note: the call before this one was killed, or the machine stopped, after {}; what it had "
        "begun was done again\n",
        report::counted(result.cases_before, "case"));
  }
  if (result.containment == campaign::Containment::kSupervisor) {
    text += "note: a supervisor contained the programs, and no process namespace (--containment)\n";
  }
  text += reasons_text(result);
  bool has_flat = false;
  for (const Finding& finding : result.findings) {
    text += finding_text(finding);
    has_flat = has_flat || finding.signature.find("-flat") != std::string::npos;
  }
  if (has_flat) {
    text +=
        "note: what ends in -flat is of points that lie in a hyperplane, or are too few not to; "
        "--full-dimension skips those\n";
  }
  return text;
}

namespace {

// ", 2 to 20 points, exponents -100 to 100, 37 families": what was tried.
std::string tried(const Result& result, const std::string& magnitudes) {
  std::string text;
  if (result.points) {
    text += fmt::format(", {} to {}", result.points->first,
                        report::counted(result.points->second, "point"));
  }
  if (!magnitudes.empty()) text += ", " + magnitudes;
  const std::size_t families = result.statistics.size();
  return text + ", " + (families == 1 ? "1 family" : fmt::format("{} families", families));
}

}  // namespace

std::string campaign_verdict(const Result& result, const std::string& program,
                             const std::string& magnitudes) {
  const std::string end = result.interrupted ? " interrupted" : "";
  if (!result.findings.empty()) {
    return fmt::format("fails: campaign {} {} {}{}", on_one_line(program),
                       report::counted(result.cases, "case"),
                       report::counted(result.findings.size(), "signature"), end);
  }
  const bool holds = !result.interrupted && judged_cases(result) > 0;
  const std::string none = judged_cases(result) == 0 ? " none of them judged" : "";
  return fmt::format("{}: campaign {} {}{}{}{}", holds ? "holds" : "undecided",
                     on_one_line(program), report::counted(result.cases, "case"), none, end,
                     holds ? tried(result, magnitudes) : "");
}

report::Json campaign_json(const Result& result, const campaign::Plan& plan,
                           const std::string& program) {
  report::Json document = {
      {"campaign", program},
      {"command", plan.subject.command},
      {"claim", name(plan.subject.claim)},
      {"seed", plan.seed},
      {"cases", result.cases},
      {"judged", judged_cases(result)},
      {"magnitudes", plan.magnitudes},
      {"interrupted", result.interrupted},
      {"containment", name(result.containment)},
      {"holds", result.findings.empty() && !result.interrupted && judged_cases(result) > 0},
      {"seconds", result.seconds}};
  if (!result.doubt.empty()) document["note"] = on_one_line(result.doubt);
  report::Json families = report::Json::object();
  for (const auto& [family, counts] : result.statistics) families[family] = counts;
  document["families"] = std::move(families);
  report::Json findings = report::Json::array();
  for (const Finding& finding : result.findings) {
    report::Json details = details_of(finding);
    details["signature"] = finding.signature;
    details["count"] = finding.count;
    details["folder"] = finding.folder;
    details["cut_off"] = finding.cut_off;
    findings.push_back(std::move(details));
  }
  document["findings"] = std::move(findings);
  return document;
}

std::string campaign_junit(const Result& result, const std::string& program) {
  std::map<std::string, std::string> texts;
  for (const Finding& finding : result.findings) texts[finding.signature] = finding_text(finding);
  std::string cases;
  std::size_t tests = 0;
  std::size_t failures = 0;
  for (const auto& [family, counts] : result.statistics) {
    ++tests;
    cases += fmt::format("    <testcase classname=\"{}\" name=\"{}: {}\"/>\n",
                         report::for_xml(on_one_line(program)), report::for_xml(family),
                         report::counted(total(counts), "case"));
    for (const auto& [what, count] : counts) {
      if (is_no_finding(what)) continue;
      ++tests;
      ++failures;
      cases += fmt::format(
          "    <testcase classname=\"{}\" name=\"{}: {}\">\n"
          "      <failure type=\"{}\" message=\"{} of {}\">{}</failure>\n    </testcase>\n",
          report::for_xml(on_one_line(program)), report::for_xml(family), report::for_xml(what),
          report::for_xml(what), count, report::counted(total(counts), "case"),
          report::for_xml(texts[what]));
    }
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      "  <testsuite name=\"circumspect campaign {}\" tests=\"{}\" failures=\"{}\" errors=\"0\" "
      "time=\"{:.3f}\">\n{}  </testsuite>\n</testsuites>\n",
      report::for_xml(on_one_line(program)), tests, failures, result.seconds, cases);
}

report::Json campaign_sarif(const Result& result) {
  std::vector<report::SarifResult> results;
  for (const Finding& finding : result.findings) {
    results.push_back({finding.signature, finding_text(finding), place_of(finding)});
  }
  return report::sarif_document(results, CIRCUMSPECT_VERSION);
}

std::string campaign_annotations(const Result& result, const std::string& program) {
  std::string lines;
  for (const Finding& finding : result.findings) {
    lines +=
        fmt::format("::error file={},title={}::{}\n", for_annotation(place_of(finding), "%\r\n:,"),
                    for_annotation(on_one_line(program) + ": " + finding.signature, "%\r\n:,"),
                    for_annotation(on_lines(finding_text(finding)), "%\r\n"));
  }
  return lines;
}

}  // namespace circumspect::cli
