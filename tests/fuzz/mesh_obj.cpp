// SPDX-License-Identifier: Apache-2.0
// For any bytes, a mesh is read with valid indices or refused with an InputError; its checks never fail.
#include <cstddef>
#include <cstdint>
#include <string>

#include "sim_core/geometry/mesh_file.h"
#include "sim_core/numerics/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const fulcrum::TriangleMesh mesh =
            fulcrum::parse_obj(std::string(reinterpret_cast<const char*>(data), size), "fuzz.obj");
        for (const auto& triangle : mesh.triangles) {
            for (const auto v : triangle) {
                if (v < 0 || static_cast<std::size_t>(v) >= mesh.vertices.size()) __builtin_trap();
            }
        }
        if (!fulcrum::check_mesh(mesh).finite) __builtin_trap();
    } catch (const fulcrum::InputError& error) {
        if (error.problem().empty() || error.hint().empty()) __builtin_trap();
    }
    return 0;
}
