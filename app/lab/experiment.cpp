// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/experiment.h"

#include <QBuffer>
#include <QByteArray>
#include <algorithm>
#include <filesystem>

#include "assessment/assets/assets.h"
#include "sim_core/lab/chart.h"
#include "sim_core/lab/experiment.h"
#include "ui/theatre/renderer/picture.h"

namespace fulcrum::app {
namespace {

std::string drawn(const lab::ExperimentResult& result) {
    std::vector<ui::PicturePanel> panels;
    for (const lab::ExperimentPanel& panel : result.panels) {
        ui::PicturePanel drawn_panel;
        drawn_panel.title = QString::fromStdString(panel.title);
        drawn_panel.eye = panel.eye;
        drawn_panel.target = panel.target;
        drawn_panel.up = panel.up;
        drawn_panel.field_of_view = panel.field_of_view;
        for (const lab::ExperimentMesh& mesh : panel.meshes) {
            ui::DrawnMesh look;
            look.mesh = mesh.mesh;
            look.colour = QVector3D(mesh.colour[0], mesh.colour[1], mesh.colour[2]);
            look.wireframe = mesh.wireframe;
            look.smooth = mesh.smooth;
            drawn_panel.meshes.push_back(std::move(look));
        }
        panels.push_back(std::move(drawn_panel));
    }
    ui::PictureOptions options;
    options.columns = result.columns;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    ui::draw_picture(panels, options).save(&buffer, "PNG", 30);
    return bytes.toStdString();
}

}  // namespace

std::vector<std::string> experiment_files() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(asset_path("experiments"))) {
        if (entry.path().extension() == ".json") files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

lab::ResultPage experiment_page(const std::string& file) {
    const lab::ExperimentResult result = lab::run_experiment(file);
    const std::string name = std::filesystem::path(file).filename().string();
    lab::ResultPage page(result.id, "Pan et al. 2011, " + result.figure,
                         "fulcrum lab experiment assets/experiments/" + name + " --output docs/results");
    page.paragraph(result.caption);
    page.file({result.id + ".png", drawn(result)}, result.caption);
    for (const lab::ExperimentChart& chart : result.charts)
        page.chart(chart.name, chart.alternative, chart.svg);
    lab::ResultTable table;
    table.columns = {"measured", "value", "unit"};
    nlohmann::json figures = nlohmann::json::array(), panels = nlohmann::json::array();
    for (const lab::ExperimentFigure& figure : result.figures) {
        table.rows.push_back({figure.name, lab::short_number(figure.value, 4), figure.unit});
        figures.push_back({{"name", figure.name}, {"value", figure.value}, {"unit", figure.unit}});
    }
    for (const lab::ExperimentPanel& panel : result.panels) panels.push_back(panel.title);
    page.table(table);
    page.document({{"id", result.id}, {"figure", result.figure}, {"panels", panels}, {"figures", figures}});
    return page;
}

}  // namespace fulcrum::app
