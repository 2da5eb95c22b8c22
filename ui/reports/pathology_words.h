// SPDX-License-Identifier: GPL-3.0-or-later
// A pathology report in words and rows, for the debrief and for paper alike. It is simulated and says so.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "assessment/pathology/pathology.h"

namespace fulcrum::ui {

/// A line of the report: what it is about, and what is said of it.
struct PathologyLine {
    QString title, words;
    bool bad = false;  ///< a positive margin, a grade below 3
    double time = -1;  ///< s of the attempt where it can be seen; -1 nowhere
};

QString sector_text(Sector sector);
/// "level 2, left"; levels are counted from 1, the most cranial.
QString place_text(int level, Sector sector);
/// Specimen, grade, coning, defects, margins, in the order a pathologist gives them.
std::vector<PathologyLine> pathology_lines(const PathologyReport& report);
/// A short label next to the map: "Mesorectum", "Grade 2, nearly complete", why.
struct PathologyLabel {
    QString title, value, why;  ///< `why` may be empty
    bool bad = false;
};
/// Grade, plane divided, circumferential margin, distal margin.
std::vector<PathologyLabel> pathology_labels(const PathologyReport& report);
/// One sector in words: how far from the plane, divided, deepest defect. For assistive technology and for the
/// line below the map.
QString sector_words(const PathologyReport& report, const SectorFinding& finding);
/// Heads of the table of sectors.
QStringList pathology_columns();
/// Its rows: every level's sectors, then the sectors over all levels, then everything.
std::vector<QStringList> pathology_rows(const PathologyReport& report);
/// What the columns' signs and words mean, one sentence each.
QString pathology_legend(const PathologyReport& report);

}  // namespace fulcrum::ui
