// SPDX-License-Identifier: Apache-2.0
// The experiments of Pan et al. 2011: scenes run without a window whose result is meshes, drawn side by side
// (`fulcrum lab experiment`). sim_core provides meshes and curves, which contain all data for drawing.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim_core/geometry/mesh.h"
#include "sim_core/numerics/types.h"

namespace fulcrum::lab {

/// A mesh at one moment. Positions in m, triangles counter-clockwise from outside.
struct ExperimentMesh {
    std::string name;  ///< "bowel", "floor", "cage", "tool" ...
    TriangleMesh mesh;
    std::array<float, 3> colour = {0.80F, 0.42F, 0.38F};  ///< linear RGB, 0 to 1
    bool wireframe = false;                               ///< drawn as its edges (the cage)
    bool smooth = true;                                   ///< vertex normals; false: facets show
};

/// One picture of the row: meshes and viewpoint.
struct ExperimentPanel {
    std::string title;
    std::vector<ExperimentMesh> meshes;
    Vector3 eye = Vector3(0, -0.3, 0.1), target = Vector3::Zero(), up = Vector3::UnitZ();  ///< m
    double field_of_view = 0.5;  ///< rad, full vertical angle
};

/// Values measured during the run, printed under the picture and in the JSON.
struct ExperimentFigure {
    std::string name, unit;
    double value = 0;
};

/// A chart next to the picture.
struct ExperimentChart {
    std::string name, alternative, svg;
};

/// Result of an experiment.
struct ExperimentResult {
    std::string id;       ///< file name of the picture, for example "fig03_force_filter"
    std::string figure;   ///< the figure of Pan et al. 2011, for example "Figs. 3 and 5"
    std::string caption;  ///< description of the picture
    int columns = 3;      ///< panels per row
    std::vector<ExperimentPanel> panels;
    std::vector<ExperimentChart> charts;
    std::vector<ExperimentFigure> figures;
};

/// Runs one experiment file (assets/experiments/*.json: kind, id, figure, caption and the kind's own numbers,
/// all SI). Throws InputError with file, place and hint. Same file, same result, bit for bit.
ExperimentResult run_experiment(const std::string& path);

}  // namespace fulcrum::lab
