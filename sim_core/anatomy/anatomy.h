// SPDX-License-Identifier: Apache-2.0
// Procedural anatomy: the abdominopelvic cavity, the rectosigmoid, its mesentery and their textures.
//
// Every function is a pure function of its parameters (the seed included): the same arguments give the same
// bytes on every machine. No I/O; any thread. Lengths in m, patient frame (origin in the middle of the pelvic
// inlet, +x to the patient's left, +y cranial, +z anterior). Parameters outside the given ranges throw
// InputError.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/bowel/skin.h"
#include "sim_core/bowel/spheres.h"
#include "sim_core/geometry/mesh.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

/// The cavity, insufflated, seen from inside.
struct PelvisParameters {
    double width = 0.125;         ///< m, transverse diameter of the inlet, 0.09 .. 0.16
    double depth = 0.115;         ///< m, inlet to floor, 0.08 .. 0.15
    double abdomen_width = 0.30;  ///< m, inner width above the iliac crests, 0.24 .. 0.40
    int triangles = 20000;        ///< requested, 2000 .. 200000; the generator rounds
    std::uint64_t seed = 1;       ///< random shape of the wall and the fat beneath it
};

struct CavityShape {
    /// Closed, outward oriented: bodies are behind its triangles (FreeSide::behind). Texture coordinates: u
    /// once around (0 .. 1), v along the axis in the same unit (one unit is about 0.4 m).
    TriangleMesh mesh;
    std::vector<float> fat;  ///< one per vertex, 0 .. 1: visibility of fat through the peritoneum
};

CavityShape make_cavity(const PelvisParameters& parameters);

/// The rectosigmoid. s = 0 is the rectum deep in the pelvis, s = length the descending colon.
struct BowelParameters {
    double length = 0.9;             ///< m, 0.6 .. 1.2
    double radius = 0.016;           ///< m, mean outer radius, 0.010 .. 0.022
    int vertices = 20000;            ///< requested, 1000 .. 200000; the generator rounds
    double haustra_spacing = 0.034;  ///< m between two semilunar folds, 0.02 .. 0.06
    double haustra_depth = 0.27;     ///< folds, fraction of the radius, 0 .. 0.4
    double taenia_width = 0.007;     ///< m, 0.003 .. 0.012
    std::uint64_t seed = 1;          ///< sizes of the haustra
};

struct BowelShape {
    /// Closed tube in the extended rest pose: along +x from 0 to the length, d3 = +x, d1 = +y, d2 = +z.
    /// Texture coordinates: u once around (0 .. 1, taeniae at 1/6, 3/6, 5/6), v = s / circumference. One
    /// coordinate per vertex: drawing must duplicate the vertices of the seam u = 1 (renderer: make_surface).
    TriangleMesh surface;
    double length = 0;          ///< m
    RadiusProfile radius;       ///< m, lumen radius by rest arc length; clamped at the ends
    std::vector<float> taenia;  ///< one per surface vertex: 1 on a taenia, 0 between
    /// In situ: on the posterior wall from the rectum over the promontory through the sigmoid loop to the
    /// left iliac fossa; points at equal arc length, the first at s = 0, the last at s = length.
    std::vector<Vector3> centre_line;
    /// Root of the mesentery on the wall: the point that belongs to the bowel at the same fraction of the
    /// length.
    std::vector<Vector3> root_line;
};

/// The bowel in place in that cavity. Tube length and arc length of the centre line agree to 1e-4.
BowelShape make_bowel(const BowelParameters& parameters, const CavityShape& cavity);
/// As above, in the cavity that make_cavity gives for these parameters.
BowelShape make_bowel(const BowelParameters& parameters, const PelvisParameters& pelvis);

/// A vertex of the mesentery: between the wall of the bowel at s and a fixed point of the root.
struct MesenteryVertex {
    double arc_length = 0;           ///< m, of the bowel
    double fraction = 0;             ///< 0 at the bowel, 1 at the root
    Vector3 root = Vector3::Zero();  ///< m
    Vector3 lift = Vector3::Zero();  ///< m, offset from the straight line due to fat and the wall beneath
};

/// The mesentery as a sheet for display. A scene with membranes simulates this sheet; in a scene with tethers
/// the tethers act instead.
struct MesenteryShape {
    TriangleMesh mesh;  ///< rest positions (bowel in situ); open sheet, drawn from both sides
    std::vector<MesenteryVertex> vertices;
    int rows = 0,
        columns = 0;  ///< along the bowel, from the bowel to the root; vertex = row * columns + column
    double attachment_radius = 0;  ///< m, from the centre line to the edge of the sheet
};

/// The sheet over shares first .. last of the bowel's length.
MesenteryShape make_mesentery(const BowelShape& bowel, const CavityShape& cavity, double first = 0.08,
                              double last = 0.97);

/// Positions and unit normals (three floats per vertex) under the given ring frames. ring_arc_lengths
/// ascends; ring_count >= 2. Does not allocate.
void evaluate_mesentery(const MesenteryShape& mesentery, const RingFrame* rings,
                        const double* ring_arc_lengths, int ring_count, float* positions, float* normals);

/// The peritoneum where it turns from the pelvic wall onto the rectum: a funnel around its end, for display.
/// It stays where the rectum is attached.
struct ReflectionShape {
    TriangleMesh mesh;  ///< open, outward side towards the cavity; u once around (0 .. 1)
    std::vector<float>
        thinness;  ///< one per vertex: 1 at the edge on the rectum, where it becomes transparent
};

ReflectionShape make_reflection(const BowelShape& bowel);

/// Eight bits per channel, rows from v = 0 up.
struct Image {
    int width = 0, height = 0, channels = 0;
    std::vector<std::uint8_t> pixels;  ///< width * height * channels
};

/// Tileable in both directions. albedo: sRGB and, in the fourth channel, wetness. normal: tangent space, the
/// components mapped from -1 .. 1; the fourth channel is height.
struct TissueTexture {
    Image albedo, normal;
};

struct AnatomyTextures {
    TissueTexture serosa;      ///< bowel: one circumference wide and two long; taeniae at u = 1/6, 3/6, 5/6
    TissueTexture fat;         ///< mesentery: 60 mm per tile
    TissueTexture peritoneum;  ///< 120 mm per tile; applied to the wall by make_wall_texture
    TissueTexture steel;       ///< brushed along v: 20 mm per tile
};

/// size: width of the serosa's tile in pixels, a power of two, 128 .. 2048; the others follow.
AnatomyTextures make_textures(std::uint64_t seed = 1, int size = 1024);

/// Areolar tissue, a tile of 40 mm: white fibres in all directions over fat, under a thin film. size as
/// above.
TissueTexture make_areolar_texture(std::uint64_t seed = 1, int size = 512);

/// The wall in one piece, by its own texture coordinates, width x width / 2 pixels (128 .. 4096): the
/// peritoneum's tile projected along the three axes and blended by the normal, with fat beneath it mixed in.
/// normal: a vector of the patient frame to be added to the wall's unit normal, mapped from -1 .. 1.
TissueTexture make_wall_texture(const CavityShape& cavity, const TissueTexture& peritoneum, int width = 2048);

}  // namespace fulcrum
