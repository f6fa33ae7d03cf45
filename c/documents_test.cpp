// What the C interface says of points, and what it compares and certifies.
#include <string>
#include <vector>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

#include "c/calls_test.hpp"

namespace circumspect::c {
namespace {

TEST_CASE("facts about points") {
  const std::vector<double> square = {0, 0, 5, 5, 1, 0, 0, 1, 0, 0, 1, 1};
  const circumspect_mesh mesh = mesh_of(square, {});
  int unique = 7;
  circumspect_document* document = nullptr;
  REQUIRE(circumspect_inspect(&mesh, &unique, &document) == CIRCUMSPECT_OK);
  CHECK(unique == 0);
  std::string facts = circumspect_document_text(document);
  std::erase_if(facts, [](char c) { return c == ' ' || c == '\n'; });
  CHECK(facts ==
        R"({"points":6,"dimension":2,"repeated":[[0,4]],"unique":false,"cospherical":[0,2,3,5]})");
  circumspect_document_free(document);
  const circumspect_mesh none = mesh_of({}, {});
  REQUIRE(circumspect_inspect(&none, &unique, &document) == CIRCUMSPECT_OK);
  CHECK(unique == 1);
  CHECK(has(circumspect_document_text(document), "-1"));
  circumspect_document_free(document);
  CHECK(circumspect_inspect(nullptr, &unique, &document) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_inspect(&mesh, nullptr, &document) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_inspect(&mesh, &unique, nullptr) == CIRCUMSPECT_INVALID_ARGUMENT);
}

TEST_CASE("comparisons and certificates") {
  const circumspect_mesh right = mesh_of(kPoints, kRight);
  const circumspect_mesh wrong = mesh_of(kPoints, kWrong);
  int answer = 7;
  circumspect_document* document = nullptr;
  REQUIRE(circumspect_compare(&right, &wrong, &answer, &document) == CIRCUMSPECT_OK);
  CHECK(answer == 0);
  CHECK(has(circumspect_document_text(document), "only_in_a"));
  circumspect_document_free(document);
  REQUIRE(circumspect_compare(&right, &right, &answer, &document) == CIRCUMSPECT_OK);
  CHECK(answer == 1);
  circumspect_document_free(document);
  for (const circumspect_mesh* mesh : {&right, &wrong}) {
    REQUIRE(circumspect_certify("delaunay", mesh, &answer, &document) == CIRCUMSPECT_OK);
    CHECK(answer == (mesh == &right ? 1 : 0));
    CHECK(std::string(circumspect_document_text(document)).size() > 20);
    circumspect_document_free(document);
  }
  CHECK(circumspect_certify("cdt", &right, &answer, &document) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_certify("delaunay", nullptr, &answer, &document) ==
        CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_compare(nullptr, &right, &answer, &document) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_compare(&right, &right, nullptr, &document) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_compare(&right, &right, &answer, nullptr) == CIRCUMSPECT_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace circumspect::c
