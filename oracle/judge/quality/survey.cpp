#include "oracle/judge/quality/survey.hpp"

#include <algorithm>
#include <limits>

#include "kernel/exact/number_text.hpp"
#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/quality/enclosed_mesh.hpp"

namespace circumspect::quality {
namespace {

// What is asked of a mesh: the least or the largest number, of what each simplex measures.
struct Question {
  Measure measure;
  bool is_largest;
};
constexpr Question kQuestions[] = {
    {Measure::kMinAngle, false},    {Measure::kMaxAngle, true},    {Measure::kMinDihedral, false},
    {Measure::kMaxDihedral, true},  {Measure::kRadiusEdge, false}, {Measure::kRadiusEdge, true},
    {Measure::kAspectRatio, false}, {Measure::kAspectRatio, true}, {Measure::kVolume, false},
    {Measure::kVolume, true},       {Measure::kArea, false},       {Measure::kArea, true},
    {Measure::kMinEdge, false},     {Measure::kEdge, true},
};

struct Bins {
  Measure measure;
  std::vector<const char*> bounds;  // as a requirement has them
};
std::vector<Bins> bins_of(int dimension) {
  const std::vector<const char*> small = {"5deg",  "10deg", "15deg", "20deg", "25deg", "30deg",
                                          "35deg", "40deg", "45deg", "50deg", "55deg"};
  const std::vector<const char*> large = {"70deg",  "80deg",  "90deg",  "100deg",
                                          "110deg", "120deg", "130deg", "140deg",
                                          "150deg", "160deg", "170deg", "175deg"};
  const std::vector<const char*> ratio = {"0.7", "0.8", "1", "1.2", "1.5",
                                          "2",   "3",   "5", "10",  "100"};
  const std::vector<const char*> aspect = {"1.5", "2",  "2.5", "3",  "4",
                                           "6",   "10", "15",  "40", "100"};
  if (dimension == 2) {
    return {{Measure::kMinAngle, small},
            {Measure::kMaxAngle, large},
            {Measure::kRadiusEdge, ratio},
            {Measure::kAspectRatio, aspect}};
  }
  if (dimension == 3) {
    return {{Measure::kMinDihedral, small},
            {Measure::kMaxDihedral, large},
            {Measure::kRadiusEdge, ratio},
            {Measure::kAspectRatio, aspect}};
  }
  return {};
}

Histogram empty_histogram(const Bins& bins) {
  Histogram histogram{bins.measure, {}, std::vector<std::size_t>(bins.bounds.size() + 1, 0)};
  for (const char* const bound : bins.bounds) {
    histogram.bounds.push_back(
        read_requirement(std::string(entry(bins.measure).name) + ":" + bound)->bound);
  }
  return histogram;
}

// Do larger numbers have larger values? The signed square of an angle falls.
bool rises(Measure measure) { return !entry(measure).is_angle; }

// The extreme that a simplex measures, or an enclosure that tells nothing if it may be flat.
template <std::size_t kDimension>
Enclosed enclosed_extreme(Measure measure, const SquaredLengths<kDimension, Enclosed>& lengths) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!spread(lengths).is_surely_positive()) return {0, kInfinity};
  const MeasureEntry& of = entry(measure);
  const bool is_largest_value = of.is_angle == of.is_at_least;
  Enclosed extreme{is_largest_value ? -kInfinity : kInfinity, 0};
  each_value(measure, lengths, [&](const Place&, const Quotient<Enclosed>& quotient) {
    const Enclosed value = quotient.above / quotient.below;
    extreme = is_largest_value ? larger(extreme, value) : smaller(extreme, value);
  });
  return extreme;
}

// What a simplex measures at least and at most, in the order of the question: where it is asked for
// the least number, or for one whose values fall, values are negated.
struct Span {
  double low, high;
};
Span span_of(const Question& question, const Enclosed& value) {
  const double error = value.error * (1 + Enclosed::kLoss);
  const bool is_negated = question.is_largest != rises(question.measure);
  const double middle = is_negated ? -value.value : value.value;
  if (!(error < std::numeric_limits<double>::infinity())) {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  return {middle - error, middle + error};
}

bool is_further(const Question& question, const Rational& value, const Rational& than) {
  return question.is_largest == rises(question.measure) ? than < value : value < than;
}

// The place of a value among the bounds of a histogram; nothing if doubles do not tell.
std::optional<std::size_t> bin_of(const Enclosed& value, Measure measure,
                                  const std::vector<Enclosed>& bounds) {
  std::size_t bin = 0;
  for (const Enclosed& bound : bounds) {
    const Enclosed room = rises(measure) ? value - bound : bound - value;
    if (room.is_surely_positive()) {
      ++bin;
    } else if (!room.is_surely_negative()) {
      return std::nullopt;
    }
  }
  return bin;
}

std::size_t exact_bin_of(const Rational& value, const Histogram& histogram) {
  return static_cast<std::size_t>(std::count_if(
      histogram.bounds.begin(), histogram.bounds.end(),
      [&](const Rational& bound) { return compare(histogram.measure, value, bound) >= 0; }));
}

// Where the answers may be: for each question the simplices that may be furthest, ascending; and
// for each histogram those whose bin is not known.
struct Candidates {
  std::vector<std::vector<std::size_t>> extremes;
  std::vector<std::vector<std::size_t>> binless;
};

class Surveyor {
 public:
  Surveyor(const Mesh& mesh, unsigned threads)
      : mesh_(mesh), threads_(threads), dimension_(dimension_of_simplices(mesh)) {
    survey_.dimension = dimension_;
    for (const Question& question : kQuestions) {
      if (!exists_for(question.measure, dimension_)) continue;
      questions_.push_back(question);
      if (place_of(question.measure) == measures_.size()) measures_.push_back(question.measure);
    }
    for (const Bins& bins : bins_of(dimension_)) {
      survey_.histograms.push_back(empty_histogram(bins));
    }
    candidates_.extremes.resize(questions_.size());
    candidates_.binless.resize(survey_.histograms.size());
  }

  Survey survey() {
    if (dimension_ < 1 || dimension_ > 3) return survey_;
    enclosed_or_else(
        mesh_, [&](const auto& enclosing) { look(enclosing); }, [&] { take_all(); });
    for (std::size_t q = 0; q < questions_.size(); ++q)
      settle(questions_[q], candidates_.extremes[q]);
    for (std::size_t h = 0; h < survey_.histograms.size(); ++h) {
      settle(survey_.histograms[h], candidates_.binless[h]);
    }
    count_set_apart();
    return std::move(survey_);
  }

 private:
  void take_all() {
    std::vector<std::size_t> all(mesh_.simplices.size());
    for (std::size_t s = 0; s < all.size(); ++s) all[s] = s;
    for (auto& list : candidates_.extremes) list = all;
    for (auto& list : candidates_.binless) list = all;
  }

  // Once over the mesh. A simplex is a candidate if it may be as far as any before it in its chunk
  // is at least; in the end, as far as any of the mesh is.
  template <class Enclosing>
  void look(const Enclosing& enclosing) {
    const std::size_t count = mesh_.simplices.size();
    std::vector<std::vector<Enclosed>> bounds;
    for (const Histogram& histogram : survey_.histograms) {
      auto& own = bounds.emplace_back();
      for (const Rational& bound : histogram.bounds) {
        own.push_back(enclosed_bound(histogram.measure, bound));
      }
    }
    std::vector<Seen> seen(fast::chunks_of(count, kChunk));
    fast::in_chunks(count, kChunk, threads_, [&](std::size_t chunk, std::size_t a, std::size_t b) {
      seen[chunk] = Seen(questions_.size(), survey_.histograms);
      std::vector<Enclosed> values(measures_.size());
      each_lengths(enclosing, a, b, [&](std::size_t s, const auto& lengths) {
        for (std::size_t m = 0; m < values.size(); ++m) {
          values[m] = enclosed_extreme(measures_[m], lengths);
        }
        see(s, values, bounds, seen[chunk]);
      });
    });
    for (std::size_t q = 0; q < questions_.size(); ++q) {
      double least = -std::numeric_limits<double>::infinity();
      for (const Seen& some : seen) least = std::max(least, some.least[q]);
      for (const Seen& some : seen) {
        for (const Suspect& suspect : some.furthest[q]) {
          if (suspect.high >= least) candidates_.extremes[q].push_back(suspect.simplex);
        }
      }
    }
    for (const Seen& some : seen) join(some);
  }

  // What is seen of the simplices of a chunk.
  struct Suspect {
    std::size_t simplex;
    double high;
  };
  struct Seen {
    Seen() = default;
    Seen(std::size_t questions, const std::vector<Histogram>& empty)
        : least(questions, -std::numeric_limits<double>::infinity()),
          furthest(questions),
          counted(empty),
          binless(empty.size()) {}

    std::vector<double> least;  // how far the furthest is at least, for each question
    std::vector<std::vector<Suspect>> furthest;
    std::vector<Histogram> counted;
    std::vector<std::vector<std::size_t>> binless;
  };

  void see(std::size_t s, const std::vector<Enclosed>& values,
           const std::vector<std::vector<Enclosed>>& bounds, Seen& seen) const {
    for (std::size_t q = 0; q < questions_.size(); ++q) {
      const Span span = span_of(questions_[q], values[place_of(questions_[q].measure)]);
      seen.least[q] = std::max(seen.least[q], span.low);
      if (span.high >= seen.least[q]) seen.furthest[q].push_back({s, span.high});
    }
    for (std::size_t h = 0; h < bounds.size(); ++h) {
      const Measure measure = survey_.histograms[h].measure;
      const auto bin = bin_of(values[place_of(measure)], measure, bounds[h]);
      if (bin) {
        ++seen.counted[h].counts[*bin];
      } else {
        seen.binless[h].push_back(s);
      }
    }
  }

  // Of a measure among measures_.
  std::size_t place_of(Measure measure) const {
    return static_cast<std::size_t>(std::find(measures_.begin(), measures_.end(), measure) -
                                    measures_.begin());
  }

  template <class Enclosing, class Visit>
  void each_lengths(const Enclosing& enclosing, std::size_t first, std::size_t last,
                    const Visit& visit) const {
    SquaredLengths<Enclosing::kDimension, double> rounded;
    for (std::size_t s = first; s < last; ++s) {
      if (enclosing.set_lengths(s, rounded)) visit(s, enclosed(rounded));
    }
  }

  void join(const Seen& seen) {
    for (std::size_t h = 0; h < seen.binless.size(); ++h) {
      auto& all = candidates_.binless[h];
      all.insert(all.end(), seen.binless[h].begin(), seen.binless[h].end());
      for (std::size_t bin = 0; bin < seen.counted[h].counts.size(); ++bin) {
        survey_.histograms[h].counts[bin] += seen.counted[h].counts[bin];
      }
    }
  }

  void settle(const Question& question, const std::vector<std::size_t>& candidates) {
    std::optional<Extreme> furthest;
    for (const std::size_t s : candidates) {
      auto found = measured(question.measure, mesh_, mesh_.simplices[s], dimension_);
      if (!found) continue;
      if (furthest && !is_further(question, found->value, furthest->found.value)) continue;
      furthest = Extreme{question.measure, question.is_largest, *std::move(found), s};
    }
    if (furthest) survey_.extremes.push_back(*std::move(furthest));
  }

  void settle(Histogram& histogram, const std::vector<std::size_t>& binless) {
    for (const std::size_t s : binless) {
      const auto found = measured(histogram.measure, mesh_, mesh_.simplices[s], dimension_);
      if (found) ++histogram.counts[exact_bin_of(found->value, histogram)];
    }
  }

  // A histogram has every simplex that is measured; edges have none.
  void count_set_apart() {
    if (survey_.histograms.empty()) {
      for (std::size_t s = 0; s < mesh_.simplices.size(); ++s) {
        const Simplex simplex = mesh_.simplices[s];
        survey_.measured += measured(Measure::kEdge, mesh_, simplex, dimension_) ? 1 : 0;
      }
    } else {
      for (const std::size_t count : survey_.histograms.front().counts) survey_.measured += count;
    }
    survey_.set_apart = mesh_.simplices.size() - survey_.measured;
  }

  const Mesh& mesh_;
  unsigned threads_;
  int dimension_;
  std::vector<Question> questions_ = {};
  std::vector<Measure> measures_ =
      {};  // of the questions, each once; those of histograms are there
  Candidates candidates_ = {};
  Survey survey_ = {};
};

}  // namespace

std::string Histogram::word(std::size_t bound) const {
  return entry(measure).is_angle ? to_decimal(bounds[bound]) + "deg"
                                 : square_root_to_decimal(bounds[bound]);
}

Survey survey(const Mesh& mesh, unsigned threads) { return Surveyor(mesh, threads).survey(); }

}  // namespace circumspect::quality
