#include "oracle/picture/page.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "oracle/model/printable.hpp"
#include "oracle/picture/overview.hpp"
#include "oracle/picture/picture.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::picture {
namespace {

using report::Json;

// As text of HTML.
std::string as_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

// Inside <script>: there "</script" and "<!--" end or change what follows, wherever they stand. In
// JSON only strings have a "<".
std::string in_script(const Json& document) {
  std::string escaped;
  for (const char c : report::document_text(document, -1)) {
    if (c == '<') {
      escaped += "\\u003c";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

// Whole lines, and no more of them than a person reads.
std::string beginning(const std::string& text) {
  constexpr std::size_t kLongest = 100'000;
  if (text.size() <= kLongest) return text;
  return text.substr(0, text.rfind('\n', kLongest) + 1) + "…\n";
}

}  // namespace

void Page::add(const Verdict& verdict, const Mesh& mesh, const std::string& mesh_name, Json report,
               const Domain* domain, const std::vector<std::string>& notes) {
  const std::size_t room = kMostCards - std::min(cards_, kMostCards);
  const std::size_t violations = verdict.violations().size();
  const std::size_t shown = std::min(room, violations);
  cards_ += shown;
  std::size_t all = 0;
  for (const auto& [rule, tally] : verdict.tallies()) all += tally.count;
  Json& listed = report["violations"];
  if (listed.size() > shown) {
    listed.erase(listed.begin() + static_cast<std::ptrdiff_t>(shown), listed.end());
  }
  if (report.contains("steiner_vertices")) {
    Json& first = report["steiner_vertices"]["first"];
    if (first.size() > kMostCards) {
      first.erase(first.begin() + static_cast<std::ptrdiff_t>(kMostCards), first.end());
      report["steiner_vertices"]["truncated"] = true;
    }
  }
  report["mesh"] = on_one_line(mesh_name);
  const std::string line = report::verdict_line(verdict, mesh, mesh_name, domain);
  Json result = {{"line", line}, {"notes", Json::array()}};
  for (const std::string& note : notes) result["notes"].push_back(on_one_line(note));
  if (shown < all) {
    result["cards_note"] = fmt::format(
        "{} of {} {} a card here{}.", shown, report::counted(all, "violation"),
        shown == 1 ? "has" : "have",
        shown < violations
            ? fmt::format("; a page has at most {}, and --format json gives the others", kMostCards)
            : "; --max-errors gives more");
  }
  result["report"] = std::move(report);
  result["pictures"] = pictures(verdict, mesh, domain, shown);
  const Json whole = overview(verdict, mesh, domain, shown);
  if (!whole.is_null()) result["overview"] = whole;
  results_.push_back(std::move(result));
  text_ += beginning(on_lines(report::explanation(verdict, mesh, domain))) + line + "\n";
  if (title_.empty()) title_ = line;
}

void Page::begin_with_campaign(Json campaign, const std::string& line) {
  campaign_ = std::move(campaign);
  campaign_["line"] = line;
  title_ = line;
  text_ = line + "\n" + text_;
}

void Page::add_finding(Json finding, const Verdict* verdict, const Mesh* mesh,
                       const std::string& mesh_name, const Domain* domain) {
  if (verdict == nullptr) {
    results_.push_back(Json::object());
    const std::string line = on_one_line(finding.value("text", ""));
    text_ += line + "\n";
    if (title_.empty()) title_ = line;
  } else {
    add(*verdict, *mesh, mesh_name,
        report::verdict(*verdict, *mesh, mesh_name, check::By::kLemma, domain), domain);
  }
  results_.back()["finding"] = std::move(finding);
}

void Page::add_facts(Facts facts, const Mesh& mesh) {
  const std::size_t shown = std::min(facts.cards.size(), kMostCards - std::min(cards_, kMostCards));
  cards_ += shown;
  const std::string line = on_one_line(facts.line);
  Json result = {{"heading", on_one_line(facts.heading)},
                 {"line", line},
                 {"verdict", facts.holds ? "holds" : "fails"},
                 {"noun", facts.noun},
                 {"facts", on_lines(facts.text)},
                 {"cards", Json::array()}};
  const std::size_t all = std::max(facts.cards_of, facts.cards.size());
  if (shown < all) {
    result["cards_note"] = fmt::format("{} of {} {} a card here; a page has at most {}.", shown,
                                       all, shown == 1 ? "has" : "have", kMostCards);
  }
  std::vector<Witness> witnesses;
  for (std::size_t i = 0; i < shown; ++i) {
    auto& [card, witness] = facts.cards[i];
    card.update(report::witness(witness, mesh));
    result["cards"].push_back(std::move(card));
    witnesses.push_back(std::move(witness));
  }
  result["pictures"] = pictures(witnesses, mesh);
  if (!facts.histograms.is_null()) result["histograms"] = std::move(facts.histograms);
  if (!facts.steps.is_null()) result["steps"] = std::move(facts.steps);
  results_.push_back(std::move(result));
  text_ += beginning(on_lines(facts.text)) + line + "\n";
  if (title_.empty()) title_ = line;
}

void Page::write(std::ostream& out) const {
  // The first words of a verdict name it; a title need not be longer.
  const std::string title = title_.size() > 200 ? title_.substr(0, 200) + "…" : title_;
  const std::pair<std::string_view, std::string> fields[] = {
      {"{{title}}", as_html(on_one_line(title))},
      {"{{text}}", as_html(text_)},
      {"{{data}}",
       in_script({{"circumspect", 1}, {"campaign", campaign_}, {"results", results_}})}};
  std::string_view rest = page_source();
  for (const auto& [field, value] : fields) {
    const std::size_t at = rest.find(field);
    out << rest.substr(0, at) << value;
    rest.remove_prefix(at + field.size());
  }
  out << rest;
}

}  // namespace circumspect::picture
