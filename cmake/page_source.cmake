# Puts page.built.html into the layer `picture`, as page_source() (oracle/picture/page.hpp). The
# page is committed as it was bundled, so that building the command needs neither Node nor a
# network. Where the layer is another build's archive, it has its page.
get_target_property(built_elsewhere circumspect_picture IMPORTED)
if(built_elsewhere)
  return()
endif()
set(page "${PROJECT_SOURCE_DIR}/oracle/picture/page/page.built.html")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${page}")
file(READ "${page}" CIRCUMSPECT_PAGE)
set(page_source "${PROJECT_BINARY_DIR}/page_source.cpp")
file(CONFIGURE OUTPUT "${page_source}" @ONLY CONTENT [=[
#include <string_view>

#pragma GCC diagnostic ignored "-Woverlength-strings"  // no compiler that is supported has such a limit

namespace circumspect::picture {

std::string_view page_source() { return R"page(@CIRCUMSPECT_PAGE@)page"; }

}  // namespace circumspect::picture
]=])
set_source_files_properties("${page_source}" PROPERTIES
  SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
target_sources(circumspect_picture PRIVATE "${page_source}")
