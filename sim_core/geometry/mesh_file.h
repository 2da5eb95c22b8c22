// SPDX-License-Identifier: Apache-2.0
// Reading and writing Wavefront OBJ. Every defect in a file throws InputError.
#pragma once

#include <iosfwd>
#include <string>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// Limits on input files.
struct MeshLimits {
    std::size_t bytes = 256u << 20;
    std::size_t vertices = 4'000'000;
    std::size_t triangles = 8'000'000;
    double coordinate_m = 1e3;  ///< largest coordinate; detects a mesh in millimetres
};

/// Reads positions, texture coordinates (one per vertex: a vertex used with several keeps the first) and
/// faces; polygons are split into fans. Vertices keep the order and numbers of the file. Throws InputError
/// with file, line or element, and hint.
TriangleMesh read_obj(const std::string& path, const MeshLimits& limits = {});

/// Parses a text in memory; `name` is used as the file name in errors.
TriangleMesh parse_obj(const std::string& text, const std::string& name, const MeshLimits& limits = {});

/// Writes v, vt if present, and f, with seventeen digits so that reading returns the same doubles.
void write_obj(std::ostream& out, const TriangleMesh& mesh);

}  // namespace fulcrum
