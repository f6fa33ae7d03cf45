#include "oracle/judge/within/reach_search.hpp"

#include <algorithm>

namespace circumspect::check {
namespace {

using Kind = ReachAnswer::Kind;

// Each step goes to the least reach that is not certain to fail: what is wrong with a cell stays
// wrong until a vertex of its image, or one that would be, is carried by another cell.
class ReachSearch {
 public:
  ReachSearch(const ExactMesh& mesh, const std::vector<RoundedPoint>& rounded,
              const std::vector<bool>& used, const Cells& cells, const DomainPieces& pieces,
              const Regions& regions, const Rational& squared_limit, unsigned threads, Work& work)
      : mesh_(mesh),
        used_(used),
        cells_(cells),
        work_(work),
        all_(cells.all()),
        apart_(pieces.least_apart(9 * squared_limit, threads)),
        limit_(apart_ ? std::min(squared_limit, Rational(apart_->squared / 9)) : squared_limit),
        reaches_(mesh, rounded, used, cells, pieces, limit_, threads),
        faces_(mesh, cells, reaches_, work),
        images_(mesh, rounded, cells, pieces, regions, reaches_, faces_, work),
        has_none_(all_.size(), false),
        squared_(reaches_.squared_least()) {}

  ReachAnswer answer() {
    while (!answer_) step();
    has_too_much_work();
    return std::move(*answer_);
  }

 private:
  // Either answers or makes the reach larger.
  void step() {
    if (has_too_much_work() || is_apart_no_more()) return;
    const Rational before = squared_;
    settle_cells();
    if (answer_ || squared_ > before) return;
    if (std::find(has_none_.begin(), has_none_.end(), true) != has_none_.end()) return give_up();
    ImageSet images = image_set(images_, cells_, squared_);
    const auto found = misplaced(images, mesh_, cells_);
    if (!found) {
      if (carriers_are_single()) finish(std::move(images));
      return;
    }
    auto next = images_.next_change(found->a, squared_);
    const auto other = images_.next_change(found->b, squared_);
    if (!next || (other && *other < *next)) next = other;
    if (next) {
      squared_ = *next;
    } else {
      breaches_.push_back(found->violation);
      give_up();
    }
  }

  bool has_too_much_work() {
    if (work_.is_too_much()) answer_ = {.kind = Kind::kTooMuchWork, .squared_reach = squared_};
    return answer_.has_value();
  }

  // Two cells that do not meet are at most three reaches apart?
  bool is_apart_no_more() {
    if (!apart_ || sign(squared_) == 0 || 9 * squared_ < apart_->squared) return false;
    answer_ = {.kind = Kind::kAmbiguous,
               .squared_reach = apart_->squared / 9,
               .cells = {apart_->a, apart_->b}};
    return true;
  }

  // The least reach at which each cell, seen alone, has an image.
  void settle_cells() {
    const Rational from = squared_;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (has_none_[i]) continue;
      Rational squared = from;
      while (const auto fault = images_.fault(all_[i], squared)) {
        if (has_too_much_work()) return;
        if (fault->is_open) open_.push_back(all_[i]);
        const bool doubled = all_[i].dimension == 0 && fault->violation.witness.vertices.size() > 1;
        if (doubled) {
          give_up();
          return;
        }
        const auto next = images_.next_reach(all_[i], squared);
        if (!next) {
          has_none_[i] = true;
          break;
        }
        squared = *next;
      }
      if (!has_none_[i]) squared_ = std::max(squared_, squared);
    }
  }

  // Where two cells of the lowest dimension are within reach of a vertex, only one of lower
  // dimension, farther away, can make it clear. The first such reach is kept: if no larger one will
  // do, it is not the mesh that is at fault.
  bool carriers_are_single() {
    std::optional<Rational> least;
    for (Vertex v = 0; mesh_.points.names(v); ++v) {
      if (!used_[static_cast<std::size_t>(v)]) continue;
      const Carrier carrier = reaches_.carrier(v, squared_);
      if (!carrier.second) continue;
      std::optional<Rational> next;
      for (const ToCell& to : reaches_.of(v)) {
        if (to.squared() <= squared_ || to.cell.dimension >= carrier.cell->dimension) continue;
        if (!next || to.squared() < *next) next = to.squared();
      }
      if (!passed_over_) {
        passed_over_ = {.kind = Kind::kAmbiguous,
                        .squared_reach = squared_,
                        .cells = {*carrier.cell, *carrier.second},
                        .vertices = {v}};
      }
      if (!next) {
        answer_ = std::move(passed_over_);
        return false;
      }
      if (!least || *next > *least) least = next;
    }
    if (least) squared_ = *least;
    return !least;
  }

  // The least reach at which two vertices of the mesh are within reach of one of the domain: it and
  // all larger ones are ambiguous, whatever has no image.
  std::optional<ReachAnswer> first_doubled() const {
    std::optional<ReachAnswer> first;
    for (const Cell cell : all_) {
      if (cell.dimension > 0 || reaches_.near(cell).size() < 2) continue;
      const Reaches::ToVertex &nearest = reaches_.near(cell)[0], &second = reaches_.near(cell)[1];
      if (first && first->squared_reach <= second.squared()) continue;
      first = {.kind = Kind::kAmbiguous,
               .squared_reach = second.squared(),
               .cells = {cell},
               .vertices = sorted(Simplex{nearest.vertex, second.vertex})};
    }
    return first;
  }

  // No reach up to the limit of the search will do.
  void give_up() {
    if (auto doubled = first_doubled()) {
      answer_ = std::move(doubled);
    } else if (apart_) {
      // Beyond it all reaches are ambiguous.
      answer_ = {.kind = Kind::kAmbiguous,
                 .squared_reach = apart_->squared / 9,
                 .cells = {apart_->a, apart_->b}};
    } else if (passed_over_) {
      answer_ = std::move(passed_over_);
    } else if (!open_.empty()) {
      answer_ = {.kind = Kind::kOpen, .squared_reach = squared_, .cells = open_};
    } else {
      answer_ = {.kind = Kind::kNone, .squared_reach = squared_};
    }
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (!has_none_[i]) continue;
      if (const auto fault = images_.fault(all_[i], squared_)) {
        breaches_.push_back(fault->violation);
      }
    }
    answer_->breaches = std::move(breaches_);
  }

  void finish(ImageSet images) {
    answer_ = {.kind = Kind::kFound, .squared_reach = squared_, .images = std::move(images)};
    for (Vertex v = 0; mesh_.points.names(v); ++v) {
      const Carrier carrier = reaches_.carrier(v, squared_);
      answer_->carriers.push_back(carrier);
      const auto& near = reaches_.of(v);
      const auto own = std::find_if(near.begin(), near.end(),
                                    [&](const ToCell& to) { return carrier.is(to.cell); });
      answer_->moved.push_back(own != near.end() && sign(own->squared()) > 0);
    }
  }

  const ExactMesh& mesh_;
  const std::vector<bool>& used_;
  const Cells& cells_;
  Work& work_;
  std::vector<Cell> all_;
  std::optional<ApartCells> apart_;
  Rational limit_;
  Reaches reaches_;
  MeshFaces faces_;
  Images images_;
  std::vector<bool> has_none_;  // of each cell: at no reach up to the limit
  std::vector<Cell> open_;
  std::vector<Violation> breaches_;
  Rational squared_;
  std::optional<ReachAnswer> passed_over_;  // an ambiguous reach at which all cells have images
  std::optional<ReachAnswer> answer_;
};

// The longest side of the bounding box, and the largest coordinate.
std::pair<Rational, Rational> extent(const std::vector<Point>& points) {
  Rational side = 0, farthest = 0;
  for (std::size_t axis = 0; !points.empty() && axis < points.front().size(); ++axis) {
    Rational low = points.front()[axis], high = low;
    for (const Point& point : points) {
      low = std::min(low, point[axis]);
      high = std::max(high, point[axis]);
    }
    side = std::max(side, Rational(high - low));
    farthest = std::max({farthest, Rational(abs(low)), Rational(abs(high))});
  }
  return {side, farthest};
}

}  // namespace

// At a small reach first: the answer does not depend on the limit once there is one, and a limit
// that is large for the mesh makes everything near everything. Programs that round are off by some
// 10⁻¹⁶ to 10⁻¹⁴.
ReachAnswer least_reach(const ExactMesh& mesh, const std::vector<bool>& used, const Cells& cells,
                        const Regions& regions, const Rational& squared_limit, unsigned threads,
                        Work& work) {
  const DomainPieces pieces(cells, work);
  const std::vector<RoundedPoint> rounded = pieces.rounding().points(mesh.points.points());
  const auto up_to = [&](const Rational& squared) {
    return ReachSearch(mesh, rounded, used, cells, pieces, regions, squared, threads, work)
        .answer();
  };
  const auto [side, farthest] = extent(cells.complex().points.points());
  const Rational small = side / 100'000'000;
  for (const std::int64_t parts :
       std::initializer_list<std::int64_t>{1'000'000'000'000, 1'000'000'000, 1'000'000}) {
    const Rational limit = farthest / to_integer(parts);
    if (squared_limit <= small * small || limit * limit >= squared_limit) break;
    ReachAnswer answer = up_to(limit * limit);
    const bool is_over = answer.kind == Kind::kFound || answer.kind == Kind::kTooMuchWork;
    if (is_over) return answer;
  }
  return up_to(squared_limit);
}

}  // namespace circumspect::check
