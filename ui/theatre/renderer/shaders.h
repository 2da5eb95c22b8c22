// SPDX-License-Identifier: GPL-3.0-or-later
// The renderer's programs in GLSL 3.30.
#pragma once

namespace fulcrum::ui::shaders {

extern const char* const head;                 ///< version line
extern const char* const light_each_fragment;  ///< before surface_vertex and sheet_fragment: large triangles
extern const char* const shade_each_fragment;  ///< after that before sheet_fragment: where shadows fall
extern const char* const within;               ///< before surface_vertex: the inner face of the bowel's wall
// Before sheet_fragment. A processor takes both sides of a condition, so what few sheets show is a program of
// its own.
extern const char* const with_ink;
extern const char* const with_fibres;
extern const char* const with_layers;
extern const char* const surface_vertex;      ///< tissue, wall
extern const char* const rigid_vertex;        ///< instruments, targets
extern const char* const light;               ///< light and shadow at a point
extern const char* const wet;                 ///< reflection of a wet surface
extern const char* const tissue_fragment;     ///< textured by coordinates: bowel, mesentery
extern const char* const sheet_fragment;      ///< a sheet that is cut: film, fibres, ink line, cut faces
extern const char* const wall_fragment;       ///< cavity, with a texture of its own
extern const char* const plain_fragment;      ///< meshes of a study
extern const char* const box_fragment;        ///< training box
extern const char* const hard;                ///< before the two of instruments
extern const char* const steel_fragment;      ///< instruments: bare steel
extern const char* const insulated_fragment;  ///< their insulation
extern const char* const ghost_fragment;      ///< instruments of a demonstration or of before
extern const char* const target_fragment;     ///< target spheres
extern const char* const mask_vertex;
extern const char* const mask_fragment;  ///< hides what lies outside the round image

}  // namespace fulcrum::ui::shaders
