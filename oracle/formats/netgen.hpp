// Meshes of Netgen, as text: .vol.
//
//     mesh3d
//     dimension
//     3
//     surfaceelements                             or surfaceelementsgi, surfaceelementsuv
//     1
//     1 1 1 0 3 1 2 3                             surface, condition, two domains, nodes from 1
//     volumeelements
//     1
//     1 4 1 2 3 4                                 domain, nodes
//     edgesegmentsgi2                             or edgesegments
//     1
//     1 0 1 2 …                                   condition, 0, two nodes
//     points
//     4
//     0 0 0                                       three coordinates of each, also in the plane
#pragma once

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/beginning.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

bool is_netgen(const Beginning& beginning);

// Conditions and domains are labels; other sections are skipped. Points are counted from 1.
Result<ElementFile> read_netgen(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
