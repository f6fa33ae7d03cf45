// For tests: whether the reader of plain files and the reader of all files give the same result.
#pragma once

#include <string>
#include <string_view>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/plain_files.hpp"
#include "oracle/formats/tetgen.hpp"

namespace circumspect::formats {

// There is no answer, or the same one as the other reader's.
enum class Answer { kNone, kSame, kOther };

template <class Number>
bool has_same_rows(const Rows<Number>& flat, const std::vector<std::vector<Rational>>& rows) {
  if (flat.rows() != rows.size()) return false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() < flat.columns()) return false;
    for (std::size_t j = 0; j < flat.columns(); ++j) {
      if (exact_value(flat.row(i)[j]) != rows[i][j]) return false;
    }
  }
  return true;
}

template <class Index>
bool has_same_rows(const Rows<Index>& flat, const std::vector<std::vector<Vertex>>& rows,
                   Vertex first_index) {
  if (flat.rows() != rows.size()) return false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != flat.columns()) return false;
    for (std::size_t j = 0; j < flat.columns(); ++j) {
      // -1 means no neighbour, whatever the first index is.
      const bool none = first_index != 0 && flat.row(i)[j] == -1 && rows[i][j] == -1;
      if (!none && flat.row(i)[j] + first_index != rows[i][j]) return false;
    }
  }
  return true;
}

inline Answer answer_to_node(const std::string& text, const PlainReading& reading = {}) {
  const auto plain = read_plain_node(RandomAccess(std::string_view(text)), reading);
  if (!plain) return Answer::kNone;
  const auto file = read_node({"f", text}, NumberReading::kDouble);
  if (!file || file->first_index != plain->first_index) return Answer::kOther;
  const bool same = plain->coordinates.columns() == file->dimension &&
                    has_same_rows(plain->coordinates, file->points.points()) &&
                    has_same_rows(plain->weights, file->attributes);
  return same ? Answer::kSame : Answer::kOther;
}

inline Answer answer_to_ele(const std::string& text, Vertex first_point,
                            const PlainReading& reading = {}) {
  const auto plain = read_plain_ele(RandomAccess(std::string_view(text)), first_point, reading);
  if (!plain) return Answer::kNone;
  const auto file = read_ele({"f", text});
  if (!file || file->first_index != plain->first_index) return Answer::kOther;
  const bool same = plain->rows.columns() == file->vertices_per_simplex &&
                    has_same_rows(plain->rows, file->simplices.lists(), first_point);
  return same ? Answer::kSame : Answer::kOther;
}

inline Answer answer_to_neigh(const std::string& text, const PlainReading& reading = {}) {
  const auto plain = read_plain_neigh(RandomAccess(std::string_view(text)), reading);
  if (!plain) return Answer::kNone;
  const auto file = read_neigh({"f", text});
  if (!file || file->first_index != plain->first_index) return Answer::kOther;
  const bool same = plain->rows.columns() == file->neighbors_per_simplex &&
                    has_same_rows(plain->rows, file->neighbors, file->first_index);
  return same ? Answer::kSame : Answer::kOther;
}

}  // namespace circumspect::formats
