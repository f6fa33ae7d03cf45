// The page: nothing of what it is given is read as markup, and it stays small.
#include "oracle/picture/page.hpp"

#include <sstream>

#include <doctest/doctest.h>

namespace circumspect::picture {
namespace {

// A strip of so many pairs of triangles, each with the wrong diagonal.
ExactMesh kites(long count) {
  std::vector<Point> points;
  std::vector<Simplex> simplices;
  for (long i = 0; i < count; ++i) {
    for (const Point& p : {Point{-2, 0}, {2, 0}, {0, 1}, {0, Rational(-1, 3)}}) {
      points.push_back({p[0] + 100 * i, p[1]});
    }
    simplices.push_back({4 * i, 4 * i + 1, 4 * i + 2});
  }
  return {PointSet(points), simplices};
}

std::string page_of(const ExactMesh& mesh, const Verdict& verdict, const std::string& name,
                    const std::vector<std::string>& notes = {}) {
  const Mesh rows = in_rows(mesh);
  Page page;
  page.add(verdict, rows, name, report::verdict(verdict, rows, name, check::By::kLemma), nullptr,
           notes);
  std::ostringstream out;
  page.write(out);
  return out.str();
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

// The JSON that stands in the page.
report::Json data_of(const std::string& page) {
  const std::string opening = R"(<script type="application/json" id="data">)";
  const std::size_t from = page.find(opening) + opening.size();
  return report::Json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST_CASE("page: names and notes hold no markup, whatever they hold") {
  const ExactMesh mesh = kites(1);
  const std::string hostile = "</script><script>alert(1)</script><!--<img src=x>\n&{{data}}.ele";
  const std::string page =
      page_of(mesh, check::judge_points(Claim::kTriangulation, mesh), hostile, {hostile});
  CHECK(page.find("<script>alert") == std::string::npos);
  CHECK(page.find("<img") == std::string::npos);
  CHECK(count_of(page, "<!--") == count_of(std::string(page_source()), "<!--"));
  const report::Json result = data_of(page)["results"][0];
  CHECK(result["report"]["mesh"] ==
        "</script><script>alert(1)</script><!--<img src=x>\\x0a&{{data}}.ele");
  CHECK(result["notes"][0] == result["report"]["mesh"]);
}

TEST_CASE("page: loads nothing, and has the licence of what it is made with") {
  const std::string source(page_source());
  CHECK(source.find("default-src 'none'") != std::string::npos);
  CHECK(source.find("Permission is hereby granted, free of charge") != std::string::npos);
  CHECK(count_of(source, "{{title}}") == 1);
  CHECK(count_of(source, "{{text}}") == 1);
  CHECK(count_of(source, "{{data}}") == 1);
  CHECK(source.size() < 700'000);
}

TEST_CASE("page: a claim that holds has a line and no card") {
  const ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {0, 1}}), {{0, 1, 2}}};
  const report::Json result =
      data_of(page_of(mesh, check::judge_points(Claim::kDelaunay, mesh), "t.ele"))["results"][0];
  CHECK(result["line"] == "holds: delaunay t.ele 3 points 1 triangle unique canonical");
  CHECK(result["pictures"].empty());
  CHECK(!result.contains("cards_note"));
}

TEST_CASE("page: all its results together have at most as many cards as one may have") {
  const ExactMesh mesh = kites(30);
  const Verdict verdict = check::judge_points(Claim::kTriangulation, mesh, {.max_violations = 0});
  Page page;
  for (int result = 0; result < 5; ++result) {
    page.add(verdict, in_rows(mesh), "k.ele",
             report::verdict(verdict, in_rows(mesh), "k.ele", check::By::kLemma));
  }
  std::ostringstream out;
  page.write(out);
  std::size_t cards = 0;
  const report::Json data = data_of(out.str());
  for (const report::Json& result : data["results"]) {
    CHECK(result["pictures"].size() == result["report"]["violations"].size());
    cards += result["pictures"].size();
  }
  CHECK(cards == kMostCards);
}

TEST_CASE("page: of very many violations the first have cards, which the page says") {
  const ExactMesh mesh = kites(150);  // the fourth point of each is unused
  const Verdict verdict = check::judge_points(Claim::kTriangulation, mesh, {.max_violations = 0});
  REQUIRE(verdict.violations().size() >= 150);
  const std::string page = page_of(mesh, verdict, "k.ele");
  const report::Json result = data_of(page)["results"][0];
  CHECK(result["pictures"].size() == kMostCards);
  CHECK(result["report"]["violations"].size() == kMostCards);
  CHECK(result["cards_note"] == "100 of " + std::to_string(verdict.violations().size()) +
                                    " violations have a card here; a page has at most 100, and "
                                    "--format json gives the others.");
  CHECK(page.size() < 5'000'000);
  Verdict many(Claim::kTriangulation, 0);
  for (Vertex v = 0; v < 600; ++v) {
    for (int again = 0; again < 20; ++again) many.add(Rule::kUnusedPoint, {.vertices = {v}});
  }
  CHECK(page_of(mesh, many, "k.ele").size() < 2'000'000);
  const Verdict few = check::judge_points(Claim::kTriangulation, mesh, {.max_violations = 2});
  CHECK(data_of(page_of(mesh, few, "k.ele"))["results"][0]["cards_note"] ==
        "2 of " + std::to_string(verdict.violations().size()) +
            " violations have a card here; --max-errors gives more.");
}

}  // namespace
}  // namespace circumspect::picture
