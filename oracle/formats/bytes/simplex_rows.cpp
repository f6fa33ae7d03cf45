#include "oracle/formats/bytes/simplex_rows.hpp"

#include <utility>

namespace circumspect::formats {

SimplexRows::SimplexRows(const std::vector<Simplex>& lists) {
  for (const Simplex& list : lists) push_back(list);
}

SimplexRows::SimplexRows(std::initializer_list<Simplex> lists) {
  for (const Simplex& list : lists) push_back(list);
}

SimplexRows::SimplexRows(Indices indices, std::size_t columns)
    : size_(indices.size() / columns), columns_(columns), indices_(std::move(indices)) {}

Simplex SimplexRows::operator[](std::size_t i) const {
  Simplex list;
  list.reserve(size_of(i));
  for (std::size_t at = begin_of(i); at < end_of(i); ++at) list.push_back(indices_[at]);
  return list;
}

void SimplexRows::push_back(std::span<const Vertex> list) {
  if (size_ == 0) {
    columns_ = list.size();
  } else if (ends_.empty() && list.size() != columns_) {
    ends_.reserve(size_ + 1);
    for (std::size_t i = 0; i < size_; ++i) ends_.push_back((i + 1) * columns_);
  }
  for (const Vertex index : list) indices_.push_back(index);
  ++size_;
  if (!ends_.empty()) ends_.push_back(indices_.size());
}

IndexLists SimplexRows::as_index_lists() && {
  if (!ends_.empty() || columns_ == 0) return IndexLists(lists());
  return std::move(indices_).as_rows(columns_);
}

std::vector<Simplex> SimplexRows::lists() const {
  std::vector<Simplex> all;
  all.reserve(size_);
  for (std::size_t i = 0; i < size_; ++i) all.push_back((*this)[i]);
  return all;
}

}  // namespace circumspect::formats
