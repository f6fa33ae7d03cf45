// All named families of domains: those of complex_families.hpp, and those that are made of a
// Delaunay triangulation to be edge-protected (Book: Section 4.5.3).
#pragma once

#include <string_view>
#include <vector>

#include "inputs/complex_families.hpp"

namespace circumspect::properties {

const std::vector<generators::ComplexFamily>& domain_families();

// Every family, without and with each one of the modifiers: those without come first.
const std::vector<generators::ComplexFamily>& modified_domain_families();

// The family with that name, which may have several modifiers, as in "planar-grid+rotated+moved";
// null if there is none. It lives as long as the program.
const generators::ComplexFamily* find_domain_family(std::string_view name);

}  // namespace circumspect::properties
