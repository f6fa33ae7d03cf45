#include "oracle/model/index_lists.hpp"

#include <algorithm>

namespace circumspect {
namespace {

template <class Index>
Rows<Index> as_rows(const std::vector<Simplex>& lists) {
  Rows<Index> rows(lists.size(), lists.front().size());
  for (std::size_t i = 0; i < lists.size(); ++i) {
    std::transform(lists[i].begin(), lists[i].end(), rows.row(i).begin(),
                   [](Vertex v) { return static_cast<Index>(v); });
  }
  return rows;
}

bool fit_32_bits(const std::vector<Simplex>& lists) {
  return std::all_of(lists.begin(), lists.end(), [](const Simplex& list) {
    return std::all_of(list.begin(), list.end(),
                       [](Vertex v) { return v == static_cast<std::int32_t>(v); });
  });
}

std::size_t size_of(const std::vector<Simplex>& lists) { return lists.size(); }
template <class Index>
std::size_t size_of(const Rows<Index>& rows) {
  return rows.rows();
}

Simplex list_of(const std::vector<Simplex>& lists, std::size_t i) { return lists[i]; }
template <class Index>
Simplex list_of(const Rows<Index>& rows, std::size_t i) {
  return {rows.row(i).begin(), rows.row(i).end()};
}

}  // namespace

IndexLists::IndexLists(std::vector<Simplex> lists) {
  if (lists.empty()) return;
  const std::size_t columns = lists.front().size();
  const bool are_rows =
      columns > 0 && std::all_of(lists.begin(), lists.end(),
                                 [columns](const Simplex& list) { return list.size() == columns; });
  if (!are_rows) {
    lists_ = std::move(lists);
  } else if (fit_32_bits(lists)) {
    lists_ = as_rows<std::int32_t>(lists);
  } else {
    lists_ = as_rows<std::int64_t>(lists);
  }
}

std::size_t IndexLists::size() const {
  return visit([](const auto& lists) { return size_of(lists); });
}

std::size_t IndexLists::columns() const {
  if (empty()) return 0;
  if (const auto* narrow = rows<std::int32_t>()) return narrow->columns();
  if (const auto* wide = rows<std::int64_t>()) return wide->columns();
  return 0;
}

Simplex IndexLists::operator[](std::size_t i) const {
  return visit([i](const auto& lists) { return list_of(lists, i); });
}

std::vector<Simplex> IndexLists::lists() const {
  std::vector<Simplex> all;
  all.reserve(size());
  visit([&all](const auto& lists) {
    for (std::size_t i = 0; i < size_of(lists); ++i) all.push_back(list_of(lists, i));
  });
  return all;
}

}  // namespace circumspect
