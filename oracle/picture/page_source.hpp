// The page without its data, with {{title}}, {{text}} and {{data}} where these belong, in this order:
// page/page.built.html, which the build puts into the library.
#pragma once

#include <string_view>

namespace circumspect::picture {

std::string_view page_source();

}  // namespace circumspect::picture
