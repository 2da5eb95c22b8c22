// SPDX-License-Identifier: Apache-2.0
// The levels of every row of the speed-accuracy table (docs/THEORY.md, section 8), with their names in scene
// files.
#pragma once

#include "sim_core/bowel/filter_level.h"
#include "sim_core/bowel/skin_scope.h"
#include "sim_core/material/exp2.h"
#include "sim_core/membrane/integrator.h"
#include "sim_core/numerics/name_table.h"
#include "sim_core/rod/rod_level.h"

namespace fulcrum {

enum class CollisionSearch : std::uint8_t {
    coherent,  ///< pairs from the last step's list
    brute,     ///< every pair, every step
};
enum class ToolContactLevel : std::uint8_t {
    dynamic_point,  ///< the contact point walks over the surface
    query,          ///< searched again every time
    jaws,           ///< the dynamic point, and jaws as boxes press the bowel
};

/// A level that only scene files name has no title.
inline constexpr NameRow<RodLevel> rod_levels[] = {{RodLevel::linearised, "linearised", ""},
                                                   {RodLevel::newton_k, "newton_k", ""},
                                                   {RodLevel::newton, "newton", ""}};
inline constexpr NameRow<MaterialLaw> material_laws[] = {{MaterialLaw::linear, "linear", ""},
                                                         {MaterialLaw::exp2, "EXP2", ""}};
inline constexpr NameRow<SkinScope> skin_scopes[] = {
    {SkinScope::local, "local", ""}, {SkinScope::local2, "local2", ""}, {SkinScope::global, "global", ""}};
inline constexpr NameRow<CollisionSearch> collision_searches[] = {{CollisionSearch::coherent, "coherent", ""},
                                                                  {CollisionSearch::brute, "brute", ""}};
inline constexpr NameRow<ToolContactLevel> tool_contact_levels[] = {
    {ToolContactLevel::dynamic_point, "dynamic_point", ""},
    {ToolContactLevel::query, "query", ""},
    {ToolContactLevel::jaws, "jaws", ""}};
inline constexpr NameRow<MembraneIntegrator> membrane_integrators[] = {
    {MembraneIntegrator::symplectic, "symplectic", ""},
    {MembraneIntegrator::global_local, "global_local", ""},
    {MembraneIntegrator::implicit, "implicit", ""}};
inline constexpr NameRow<FilterLevel> filter_levels[] = {{FilterLevel::off, "off", ""},
                                                         {FilterLevel::grade_0, "0", ""},
                                                         {FilterLevel::grade_1, "1", ""},
                                                         {FilterLevel::grade_2, "2", ""},
                                                         {FilterLevel::adaptive, "adaptive", ""}};
static_assert(in_order(rod_levels) && in_order(material_laws) && in_order(skin_scopes) &&
              in_order(collision_searches) && in_order(tool_contact_levels) &&
              in_order(membrane_integrators) && in_order(filter_levels));

}  // namespace fulcrum
