#include "command/inspect/inspect_points.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "command/inspect/inspect_simplex.hpp"
#include "command/inspect/simplex_counts.hpp"
#include "command/output/expected_time.hpp"
#include "construct/delaunay.hpp"
#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"
#include "reference/constructions.hpp"
#include "reference/delaunay/genericity.hpp"

namespace circumspect::cli {
namespace {

// What Definition 4.2 says of a set, as far as it was looked at.
struct Genericity {
  enum class Answer { kGeneric, kNotGeneric, kUndecided } answer;
  Simplex cospherical = {};  // k+2 points on one sphere, if not generic
  bool unique = true;        // is there only one Delaunay triangulation?
};

// (n choose r), or `cap` if that is less.
std::size_t binomial(std::size_t n, std::size_t r, std::size_t cap) {
  if (r > n) return 0;
  std::size_t result = 1;
  for (std::size_t i = 1; i <= r; ++i) {
    result = result * (n - r + i) / i;
    if (result > cap) return cap;
  }
  return result;
}

// An empty ball with k+2 points on it is found from the Delaunay triangulation, whatever the size
// of the set; the other balls take a look at every (k+2)-subset.
Genericity genericity(const PointSet& points, const construct::CanonicalDelaunay& canonical,
                      std::size_t subsets) {
  if (!canonical.is_known_unique) {
    const auto empty_ball =
        reference::cospherical_points_of_an_empty_ball(points, canonical.triangulation);
    if (empty_ball) return {Genericity::Answer::kNotGeneric, *empty_ball, false};
  }
  const auto size = static_cast<std::size_t>(points.dimension() + 2);
  if (subsets != 0 && binomial(points.size(), size, subsets + 1) > subsets) {
    return {Genericity::Answer::kUndecided};
  }
  const auto any_ball = delaunay::cospherical_points(points);
  if (any_ball) return {Genericity::Answer::kNotGeneric, *any_ball};
  return {Genericity::Answer::kGeneric};
}

// The ball whose sphere the cospherical points share: that of an affine basis of them.
Ball common_ball(const PointSet& points, const Simplex& cospherical) {
  Simplex basis;
  for (const std::size_t i : affine_hull(coordinates(points, cospherical)).basis) {
    basis.push_back(cospherical[i]);
  }
  return circumball(points, basis);
}

std::string_view answer_word(Genericity::Answer answer) {
  switch (answer) {
    case Genericity::Answer::kGeneric:
      return "generic";
    case Genericity::Answer::kNotGeneric:
      return "not-generic";
    case Genericity::Answer::kUndecided:
      return "generic-undecided";
  }
  return "";
}

// "simplices: 19 of at most 28 edges, 18 of at most 40 triangles, 6 of at most 19 tetrahedra"
std::string counts_text(const std::vector<SimplexCount>& counts) {
  std::string text;
  for (const SimplexCount& count : counts) {
    const std::string noun =
        report::simplices_noun(count.dimension, count.bound.value_or(count.count));
    text += fmt::format("{}{}{} {}{}", text.empty() ? "simplices: " : ", ", count.count,
                        count.bound ? fmt::format(" of at most {}", *count.bound) : "",
                        count.dimension > 3 ? fmt::format("{}-", count.dimension) : "", noun);
  }
  return text.empty() ? "" : text + "\n";
}

std::string duplicates_text(const ExactMesh& mesh, const std::vector<Duplicate>& duplicates) {
  std::string text;
  for (const Duplicate& duplicate : duplicates) {
    text += fmt::format("duplicate: points {} and {} are equal\n",
                        duplicate.kept + mesh.first_index, duplicate.again + mesh.first_index);
  }
  return text;
}

std::string genericity_text(const ExactMesh& mesh, const Genericity& genericity) {
  if (genericity.answer == Genericity::Answer::kUndecided) {
    return "generic: undecided, more subsets than --subsets; no empty ball has too many points\n";
  }
  if (genericity.cospherical.empty()) return "";
  const Ball ball = common_ball(mesh.points, genericity.cospherical);
  std::string centre;
  for (const Rational& x : ball.centre) centre += " " + to_decimal(x);
  return fmt::format("cospherical: points {} on {} of centre ~{} radius ~ {}\n",
                     report::labels(mesh, genericity.cospherical),
                     genericity.unique ? "a sphere" : "an empty sphere", centre,
                     square_root_to_decimal(ball.squared_radius));
}

report::Json genericity_json(const ExactMesh& mesh, const Genericity& genericity) {
  report::Json object = {{"generic", answer_word(genericity.answer)},
                         {"unique", genericity.unique}};
  if (genericity.cospherical.empty()) return object;
  report::Json vertices = report::Json::array();
  report::Json coordinates = report::Json::object();
  for (const Vertex v : genericity.cospherical) {
    vertices.push_back(mesh.label(v));
    coordinates[std::to_string(mesh.label(v))] = report::point(mesh.points[v]);
  }
  object["cospherical"] = {{"vertices", vertices},
                           {"ball", report::ball(common_ball(mesh.points, genericity.cospherical))},
                           {"coordinates", coordinates}};
  return object;
}

report::Json counts_json(const std::vector<SimplexCount>& counts) {
  report::Json array = report::Json::array();
  for (const SimplexCount& count : counts) {
    report::Json entry = {{"dimension", count.dimension}, {"count", count.count}};
    if (count.bound) entry["bound"] = *count.bound;
    array.push_back(entry);
  }
  return array;
}

constexpr std::string_view kDimension = "dimension", kGenericity = "genericity",
                           kSimplices = "simplices";

// Prints what is found as soon as it is found, and collects it for JSON and for the last line.
class Inspected {
 public:
  Inspected(const LoadedPoints& loaded, const std::vector<Duplicate>& repeated,
            const PointsInspection& options, const std::vector<std::string>& only, Output& output,
            picture::Page* page)
      : loaded_(loaded),
        repeated_(repeated),
        options_(options),
        only_(only),
        output_(output),
        page_(page) {}

  void run() {
    add_dimension();
    if (!add_answers()) return;
    if (wants(kGenericity) || wants(kSimplices)) {
      const construct::CanonicalDelaunay canonical = triangulated();
      if (wants(kGenericity)) add_genericity(canonical);
      if (wants(kSimplices)) add_counts(canonical.triangulation);
    }
    facts_.line = fmt::format("inspected: {} {}", on_one_line(loaded_.name), summary_);
    output_.text(facts_.line + "\n");
    if (output_.wants_json()) output_.json(known_);
    if (page_ == nullptr) return;
    facts_.heading = loaded_.name;
    page_->add_facts(std::move(facts_), around_);
  }

 private:
  bool wants(std::string_view fact) const {
    return only_.empty() || std::find(only_.begin(), only_.end(), fact) != only_.end();
  }
  const ExactMesh& mesh() const { return loaded_.mesh; }
  const PointSet& points() const { return mesh().points; }

  void add_dimension() {
    const std::size_t read = points().size() + repeated_.size();
    const std::string dimension =
        fmt::format("dimension {} of {}", points().dimension(), points().ambient_dimension());
    summary_ = fmt::format("{} {} {}", report::counted(read, "point"),
                           report::counted(repeated_.size(), "duplicate"), dimension);
    tell(duplicates_text(mesh(), repeated_) + fmt::format("points: {}\n", summary_));
    report::Json repeated = report::Json::array();
    for (const Duplicate& duplicate : repeated_) {
      repeated.push_back(
          {duplicate.kept + mesh().first_index, duplicate.again + mesh().first_index});
    }
    know({{"input", loaded_.name},
          {"points", read},
          {"duplicates", repeated},
          {"ambient_dimension", points().ambient_dimension()},
          {"dimension", points().dimension()}});
  }

  // What was asked about single simplices. False, and said, if a question has no sense.
  bool add_answers() {
    report::Json answers = report::Json::array();
    for (const std::string& vertices : options_.simplices) {
      const auto answer = inspect_simplex(mesh(), repeated_, vertices);
      if (!answer) {
        output_.error(ExitCode::kUsage, "input", loaded_.name, answer.error());
        return false;
      }
      tell(answer->text + "\n");
      answers.push_back(answer->json);
    }
    if (!answers.empty()) know({{"simplices", answers}});
    return true;
  }

  construct::CanonicalDelaunay triangulated() {
    output_.begin("triangulating " + loaded_.name,
                  seconds_of_triangulating(points().size(), points().dimension()));
    return construct::any_canonical_delaunay(points(), output_.progress());
  }

  void add_genericity(const construct::CanonicalDelaunay& canonical) {
    output_.begin("deciding whether " + loaded_.name + " is generic");
    const Genericity found = genericity(points(), canonical, options_.subsets);
    tell(genericity_text(mesh(), found));
    if (page_ != nullptr && !found.cospherical.empty()) {
      draw_cospherical(found, canonical.triangulation);
    }
    summary_ +=
        fmt::format(" {} {}", answer_word(found.answer), found.unique ? "unique" : "not-unique");
    know(genericity_json(mesh(), found));
  }

  void add_counts(const Triangulation& triangulation) {
    output_.begin("counting the simplices of " + loaded_.name);
    const std::vector<SimplexCount> counts = simplex_counts(triangulation, points().size());
    tell(counts_text(counts));
    know({{"simplices_of_canonical_triangulation", counts_json(counts)}});
  }

  // The sphere, among the simplices of the canonical triangulation.
  void draw_cospherical(const Genericity& found, const Triangulation& triangulation) {
    const std::string words = found.unique ? "a sphere" : "an empty sphere";
    Witness witness;
    witness.vertices = found.cospherical;
    witness.ball = common_ball(points(), found.cospherical);
    facts_.cards.emplace_back(
        report::Json{
            {"meaning", fmt::format("{} points lie on {}", found.cospherical.size(), words)},
            {"caption",
             fmt::format("Points {} lie on {}.", report::labels(mesh(), found.cospherical), words)},
            {"around", "simplices of the canonical triangulation"},
            {"ball_words", words}},
        std::move(witness));
    around_ = in_rows({points(), triangulation.simplices(), {}, mesh().first_index});
    around_.labels = mesh().labels;
  }

  void tell(const std::string& text) {
    output_.text(text);
    if (page_ != nullptr) facts_.text += text;
  }

  void know(const report::Json& more) {
    known_.update(more);
    output_.know(known_);
  }

  const LoadedPoints& loaded_;
  const std::vector<Duplicate>& repeated_;
  const PointsInspection& options_;
  const std::vector<std::string>& only_;
  Output& output_;
  picture::Page* page_;
  picture::Facts facts_;  // for the page
  Mesh around_;
  std::string summary_;
  report::Json known_ = report::Json::object();
};

}  // namespace

std::vector<std::string> point_facts() {
  return {std::string(kDimension), std::string(kGenericity), std::string(kSimplices)};
}

void inspect_points(const std::string& path, const InputOptions& input,
                    const PointsInspection& options, const std::vector<std::string>& only,
                    Output& output, picture::Page* page) {
  output.begin("reading " + path);
  // Duplicates are one of the facts asked for: they are merged and reported, not rejected.
  InputOptions merging = input;
  merging.duplicates = Duplicates::kMerge;
  const auto loaded = load_points(path, merging);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "input", path, loaded.error());
    return;
  }
  output.notes(loaded->notes);
  Inspected(*loaded, loaded->merged, options, only, output, page).run();
}

}  // namespace circumspect::cli
