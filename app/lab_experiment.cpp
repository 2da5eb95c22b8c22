// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab_experiment.h"

#include <QBuffer>
#include <QByteArray>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <filesystem>

#include "app/assets.h"
#include "sim_core/lab/chart.h"
#include "sim_core/lab/experiment.h"
#include "sim_core/lab/picture.h"

namespace fulcrum::app {
namespace {

constexpr int panel_width = 400, panel_height = 310, title_height = 24;

std::string drawn(const lab::ExperimentResult& result) {
    const int count = static_cast<int>(result.panels.size()), columns = std::max(1, result.columns),
              rows = (count + columns - 1) / columns;
    QImage sheet(columns * panel_width, rows * (panel_height + title_height), QImage::Format_RGB888);
    sheet.fill(Qt::white);
    QPainter painter(&sheet);
    QFont font = painter.font();
    font.setPixelSize(14);
    painter.setFont(font);
    for (int i = 0; i < count; ++i) {
        const lab::ExperimentPanel& panel = result.panels[static_cast<std::size_t>(i)];
        const lab::Picture picture = lab::draw_panel(panel, panel_width, panel_height);
        const QImage image(picture.rgb.data(), picture.width, picture.height, 3 * picture.width,
                           QImage::Format_RGB888);
        const int x = (i % columns) * panel_width, y = (i / columns) * (panel_height + title_height);
        painter.drawImage(x, y + title_height, image);
        painter.drawText(x + 8, y + 17, QString::fromStdString(panel.title));
    }
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    sheet.save(&buffer, "PNG", 30);
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
    lab::ResultPage page(result.id, "The paper's " + result.figure,
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
