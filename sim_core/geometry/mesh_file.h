// SPDX-License-Identifier: Apache-2.0
// Reading and writing Wavefront OBJ. The edge of the program: everything wrong in a file throws InputError.
#pragma once

#include <iosfwd>
#include <string>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// Limits on what comes from outside.
struct MeshLimits {
    std::size_t bytes = 256u << 20;
    std::size_t vertices = 4'000'000;
    std::size_t triangles = 8'000'000;
    double coordinate_m = 1e3;  ///< no coordinate beyond this: a mesh in millimetres is caught at once
};

/// Reads positions, texture coordinates (one a vertex: a vertex used with several keeps the first) and faces;
/// polygons become fans. Vertices keep the file's order and number. Throws InputError naming file, line or
/// element, and hint.
TriangleMesh read_obj(const std::string& path, const MeshLimits& limits = {});

/// The same from a text in memory; name stands for the file in errors.
TriangleMesh parse_obj(const std::string& text, const std::string& name, const MeshLimits& limits = {});

/// Writes v, vt where present, f; seventeen digits, so that reading gives the same doubles.
void write_obj(std::ostream& out, const TriangleMesh& mesh);

}  // namespace fulcrum
