// SPDX-License-Identifier: Apache-2.0
#include "sim_core/geometry/mesh_file.h"

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string_view>

#include "sim_core/numerics/files.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

std::string_view next_token(std::string_view& rest) {
    while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
    std::size_t length = 0;
    while (length < rest.size() && !is_space(rest[length])) ++length;
    const std::string_view token = rest.substr(0, length);
    rest.remove_prefix(length);
    return token;
}

double read_number(std::string_view token, const std::string& name, std::size_t line) {
    if (!token.empty() && token.front() == '+') token.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (token.empty() || error != std::errc() || end != token.data() + token.size() ||
        !std::isfinite(value)) {
        throw InputError(name, std::to_string(line),
                         "'" + std::string(token.substr(0, 40)) + "' is not a finite number",
                         "write three coordinates in metres after v, two after vt");
    }
    return value;
}

struct Scan {
    std::vector<Vector3> vertices;
    std::size_t corners = 0;
    std::vector<std::size_t> face_lines;
};

// The OBJ loader accepts text where a number is required and rounds inexactly. This pass rejects such text
// and keeps the exact values.
Scan scan_lines(const std::string& text, const std::string& name, const MeshLimits& limits) {
    Scan scan;
    std::size_t line_number = 0, begin = 0;
    while (begin < text.size()) {
        ++line_number;
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line(text.data() + begin, end - begin);
        begin = end + 1;
        if (line.find('\0') != std::string_view::npos) {
            throw InputError(name, std::to_string(line_number), "the line contains a zero byte",
                             "give a text file in OBJ format");
        }
        const std::string_view keyword = next_token(line);
        if (keyword == "v") {
            Vector3 vertex;
            for (int i = 0; i < 3; ++i) vertex[i] = read_number(next_token(line), name, line_number);
            if (vertex.cwiseAbs().maxCoeff() > limits.coordinate_m) {
                throw InputError(name, std::to_string(line_number), "a coordinate exceeds 1000 m",
                                 "give coordinates in metres");
            }
            if (scan.vertices.size() >= limits.vertices) {
                throw InputError(name, std::to_string(line_number), "too many vertices",
                                 "give at most " + std::to_string(limits.vertices));
            }
            scan.vertices.push_back(vertex);
        } else if (keyword == "vt") {
            for (int i = 0; i < 2; ++i) read_number(next_token(line), name, line_number);
        } else if (keyword == "f") {
            std::size_t corners = 0;
            while (!next_token(line).empty()) ++corners;
            if (corners < 3) {
                throw InputError(name, std::to_string(line_number), "a face has fewer than three corners",
                                 "give at least three vertex numbers after f");
            }
            scan.corners += corners;
            scan.face_lines.push_back(line_number);
            if (scan.corners - 2 * scan.face_lines.size() > limits.triangles) {
                throw InputError(name, std::to_string(line_number), "too many triangles",
                                 "give at most " + std::to_string(limits.triangles));
            }
        }
    }
    return scan;
}

}  // namespace

TriangleMesh parse_obj(const std::string& text, const std::string& name, const MeshLimits& limits) {
    if (text.size() > limits.bytes) {
        throw InputError(name, "", "the file is larger than " + std::to_string(limits.bytes) + " bytes",
                         "give a smaller mesh");
    }
    Scan scan = scan_lines(text, name, limits);
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    std::istringstream stream(text);
    const bool read =
        tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr, false, false);
    if (!read || !error.empty()) {
        while (!error.empty() && (error.back() == '\n' || error.back() == ' ')) error.pop_back();
        throw InputError(name, "", error.empty() ? "the file is not valid OBJ" : error,
                         "number vertices from 1 in faces");
    }
    TriangleMesh mesh;
    mesh.vertices = std::move(scan.vertices);
    const auto texture_count = static_cast<std::int64_t>(attributes.texcoords.size() / 2);
    std::vector<char> textured(texture_count > 0 ? mesh.vertices.size() : 0, 0);
    if (texture_count > 0) mesh.texture_coordinates.assign(mesh.vertices.size(), Eigen::Vector2d::Zero());
    std::size_t face_number = 0;
    for (const auto& shape : shapes) {
        std::size_t corner = 0;
        for (const auto sides : shape.mesh.num_face_vertices) {
            const std::size_t count = static_cast<std::size_t>(sides);
            const auto place = [&] { return "face " + std::to_string(face_number + 1); };
            for (std::size_t i = 0; i < count; ++i) {
                const auto& index = shape.mesh.indices[corner + i];
                if (index.vertex_index < 0 ||
                    static_cast<std::size_t>(index.vertex_index) >= mesh.vertices.size()) {
                    throw InputError(name, place(),
                                     "vertex " + std::to_string(index.vertex_index + 1) + " does not exist",
                                     "use vertices 1 to " + std::to_string(mesh.vertices.size()));
                }
                if (texture_count > 0 && index.texcoord_index >= 0 && index.texcoord_index < texture_count) {
                    const auto v = static_cast<std::size_t>(index.vertex_index);
                    const auto t = 2 * static_cast<std::size_t>(index.texcoord_index);
                    if (!textured[v])
                        mesh.texture_coordinates[v] = {attributes.texcoords[t], attributes.texcoords[t + 1]};
                    textured[v] = 1;
                }
            }
            for (std::size_t i = 1; i + 1 < count; ++i) {
                mesh.triangles.push_back({shape.mesh.indices[corner].vertex_index,
                                          shape.mesh.indices[corner + i].vertex_index,
                                          shape.mesh.indices[corner + i + 1].vertex_index});
            }
            corner += count;
            ++face_number;
        }
    }
    if (face_number != scan.face_lines.size()) {
        throw InputError(name, "", "a face could not be parsed",
                         "write f with vertex numbers, v, v/vt or v/vt/vn");
    }
    if (mesh.vertices.empty())
        throw InputError(name, "", "the file has no vertices", "give lines that begin with v");
    return mesh;
}

TriangleMesh read_obj(const std::string& path, const MeshLimits& limits) {
    require_regular_file(path);
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file)
        throw InputError(path, "", "the file cannot be opened", "check the path and the read permission");
    const std::streamoff size = file.tellg();
    if (size < 0 || static_cast<std::uint64_t>(size) > limits.bytes) {
        throw InputError(path, "", "this is not a file of at most " + std::to_string(limits.bytes) + " bytes",
                         "give a smaller mesh");
    }
    std::string text(static_cast<std::size_t>(size), '\0');
    file.seekg(0);
    file.read(text.data(), size);
    if (!file)
        throw InputError(path, "", "the file cannot be read", "check that it is a regular, complete file");
    return parse_obj(text, path, limits);
}

void write_obj(std::ostream& out, const TriangleMesh& mesh) {
    const auto precision = out.precision(17);
    for (const auto& v : mesh.vertices) out << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
    const bool textured = mesh.texture_coordinates.size() == mesh.vertices.size() && !mesh.vertices.empty();
    if (textured) {
        for (const auto& uv : mesh.texture_coordinates) out << "vt " << uv.x() << ' ' << uv.y() << '\n';
    }
    for (const auto& triangle : mesh.triangles) {
        out << 'f';
        for (const auto v : triangle) {
            out << ' ' << v + 1;
            if (textured) out << '/' << v + 1;
        }
        out << '\n';
    }
    out.precision(precision);
}

}  // namespace fulcrum
