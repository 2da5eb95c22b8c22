// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/cut_figures.h"

#include <cmath>

#include "sim_core/lab/svg.h"

namespace fulcrum::lab {
namespace {

constexpr double mm = 0.001;

struct Frame {
    double x, y, scale;  ///< pixels of the origin, pixels per m
    double across(const Vector3& p) const { return x + scale * p.x(); }
    double down(const Vector3& p) const { return y - scale * p.y(); }
};

void draw_line(Svg& svg, const Frame& frame, const Vector3& a, const Vector3& b, const char* colour,
               double width, bool dashed) {
    svg.line(frame.across(a), frame.down(a), frame.across(b), frame.down(b), colour, width, dashed);
}

void draw_mesh(Svg& svg, const Frame& frame, const TriangleMesh& mesh, const char* colour, bool dashed) {
    for (const Triangle& t : mesh.triangles)
        for (std::size_t e = 0; e < 3; ++e)
            draw_line(svg, frame, mesh.vertices[static_cast<std::size_t>(t[e])],
                      mesh.vertices[static_cast<std::size_t>(t[(e + 1) % 3])], colour, 1, dashed);
}

void draw_visible(Svg& svg, const Frame& frame, const CutMesh& mesh) {
    for (const Triangle& t : mesh.visible_triangles())
        for (std::size_t e = 0; e < 3; ++e)
            draw_line(svg, frame, mesh.vertex(t[e]).rest, mesh.vertex(t[(e + 1) % 3]).rest, series_colour(0),
                      1.5, false);
}

}  // namespace

TriangleMesh figure_triangle() {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {10 * mm, 0, 0}, {5 * mm, 9 * mm, 0}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

std::vector<CutExample> cut_examples() {
    const double w = 1.2 * mm;
    const auto at = [](double x, double y) { return Vector3(x * mm, y * mm, 0); };
    return {
        {'a', "start or end triangle, no corner in the band", at(5, 3.5), at(12, 4.5), w},
        {'b', "start or end triangle, one corner on the border", at(6.36, 3.48), at(13.56, -1.92), w},
        {'c', "start or end triangle, one corner in the band", at(5, 3), at(12.5, -1.5), w},
        {'d', "connecting, two corners in, the third left of the blade", at(-3, 0), at(13, 0), w},
        {'e', "connecting, two corners in, the third right of the blade", at(13, 0), at(-3, 0), w},
        {'f', "connecting, one corner in, the others left", at(-3, 5.4), at(3, -5.4), w},
        {'g', "connecting, one corner in, the others right", at(3, -5.4), at(-3, 5.4), w},
        {'h', "connecting, one corner in, the others on either side", at(-3, -1.65), at(12, 6.6), w},
        {'i', "connecting, no corner in the band", at(-2, 4), at(12, 4.5), w},
        {'j', "connecting, all corners in the band", at(-5, 4), at(15, 4), 12 * mm},
    };
}

RestBlade run_example(const CutExample& example, RestBlade::Tally& tally) {
    const TriangleMesh mesh = figure_triangle();
    RestBlade blade(mesh, {}, CutMesh::capacity_for(mesh, 64));
    blade.stroke({example.from, example.to}, example.width, BladeEnd::square, tally);
    return blade;
}

ResultPage cut_figures_page() {
    ResultPage page("fig12_cut_cases", "Fig. 12: the ten ways a blade divides a triangle",
                    "fulcrum lab cut --output docs/results");
    page.paragraph(
        "One rule produces all ten cases: subtract the band of the blade from the triangle and triangulate "
        "the rest. Dashed: the triangle before the cut. Red: the borders of the band and the path of the "
        "blade. Blue: the triangles drawn after the cut. The lower letter is the case that the product "
        "counted, from the corners alone; the upper letter is the case of Fig. 12.");
    Svg svg(1000, 470);
    ResultTable table;
    table.name = "fig12_cases";
    table.columns = {"figure", "counted as", "triangles after", "area cut away, mm2", "least angle, degrees"};
    nlohmann::json cases = nlohmann::json::array();
    int place = 0;
    for (const CutExample& example : cut_examples()) {
        RestBlade::Tally tally;
        const RestBlade blade = run_example(example, tally);
        const CutMesh& mesh = blade.mesh();
        std::string counted;
        for (std::size_t c = 0; c < tally.cases.count.size(); ++c)
            for (int n = 0; n < tally.cases.count[c]; ++n)
                counted += std::string("12") + static_cast<char>('a' + c);
        const Frame frame{40 + 195.0 * (place % 5), 180 + 225.0 * (place / 5), 12000};
        draw_mesh(svg, frame, figure_triangle(), "#888888", true);
        draw_visible(svg, frame, mesh);
        const Vector3 along = (example.to - example.from).normalized();
        const Vector3 left = 0.5 * example.width * Vector3(-along.y(), along.x(), 0);
        for (const double side : {-1.0, 1.0})
            draw_line(svg, frame, example.from + side * left, example.to + side * left, series_colour(1), 1,
                      false);
        draw_line(svg, frame, example.from, example.to, series_colour(1), 1, true);
        svg.text(frame.x + 60, frame.y - 140, std::string("Fig. 12") + example.letter, 15, "middle", 0,
                 "#222222", true);
        svg.text(frame.x + 60, frame.y + 28, "counted: " + (counted.empty() ? "nothing" : counted), 12,
                 "middle");
        const double taken = mesh.area_removed() / (mm * mm), angle = least_angle_deg(mesh);
        const bool left_any = mesh.visible_count() > 0;
        table.rows.push_back({std::string("12") + example.letter + ": " + example.what, counted,
                              std::to_string(mesh.visible_count()), pixel(taken),
                              left_any ? pixel(angle) : "none left"});
        cases.push_back({{"figure", std::string("12") + example.letter},
                         {"what", example.what},
                         {"counted", counted},
                         {"visible_triangles", mesh.visible_count()},
                         {"area_removed_m2", mesh.area_removed()},
                         {"min_angle_deg", left_any ? nlohmann::json(angle) : nlohmann::json()}});
        ++place;
    }
    page.chart("fig12_cases", "Ten triangles, each divided as Fig. 12 names it", svg.finish());
    page.table(table);

    page.document({{"cases", cases}});
    return page;
}

}  // namespace fulcrum::lab
