// The rules that a mesh can break: stable identifiers. The list (oracle/model/rules.def) may grow;
// an identifier never changes its meaning.
#pragma once

#include <span>
#include <string_view>

namespace circumspect {

// The value of a rule is its number, which files of cells store.
enum class Rule {
#define RULE(number, name, ...) name = number,
#include "oracle/model/rules.def"
};

// The stages of a judgement; a verdict names the rules of an earlier stage first.
enum class Stage {
  kSimplices,  // each by itself, and whether two are the same
  kFacets,     // whether simplices meet in them
  kVertices,   // whether points are vertices
  kHull,       // the boundary, and how often what is inside is covered
  kDomain,     // the cells of a domain, and what they enclose
  kDelaunay,
  kQuality,  // what was required of each simplex
};

enum class JudgedOf { kPoints, kDomains, kBoth };

// What a picture of a witness draws beside the cells that it names.
enum class Mark {
  kCells,           // nothing more
  kEdges,           // the same, but simplices without their faces
  kNoBall,          // a ball that is missing
  kOrder,           // arrows in the order of the vertices
  kCommonPart,      // what two simplices both cover
  kHole,            // from the face to the vertex
  kNearest,         // the vertex of the mesh that is nearest
  kCuts,            // where simplices cut a polygon
  kBareSide,        // an arrow to the side of the face that nothing covers
  kBall,            // the circumball, and the simplex across the face
  kBallAndSight,    // the same, and lines of sight
  kOrthogonalBall,  // the ball that is orthogonal to weighted vertices
  kSmallestBall,    // the smallest ball through the corners
};

struct RuleEntry {
  Rule rule;
  std::string_view identifier;  // "delaunay.facet-not-local"
  Stage stage;
  JudgedOf of;
  Mark mark;
  std::string_view meaning;   // what is wrong when it is broken, one clause
  std::string_view sentence;  // what a picture shows: oracle/picture/caption.hpp
  std::string_view theorem;   // "theory/points.md#delaunay", below docs/
  std::string_view unproved;  // why there are no refutations by it, or only for some meshes
};

// All rules, by stage and within one by number.
std::span<const RuleEntry> rules();

const RuleEntry& entry(Rule rule);
std::string_view identifier(Rule rule);
std::string_view meaning(Rule rule);
Stage stage(Rule rule);
// "simplices", "facets", …
std::string_view name(Stage stage);

// The order in which a verdict lists rules.
struct JudgedBefore {
  bool operator()(Rule a, Rule b) const;
};

}  // namespace circumspect
