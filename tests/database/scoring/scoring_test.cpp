// SPDX-License-Identifier: GPL-3.0-or-later
// What a score says once it comes back from its rows.
#include "database/scoring/scoring.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "assessment/metrics/metrics_json.h"

namespace fulcrum {
namespace {

TEST(ScoreRows, SayTheSameOnceTheyAreRead) {
    ScoredAttempt scored;
    MetricResult path;
    path.id = "path_len";
    path.version = 3;
    path.hand = "left";
    path.tissue = "areolar";
    path.value = 812.5;
    path.unit = "mm";
    path.direction = Direction::lower;
    path.evidence.push_back({0.25, 31.5});
    path.evidence.push_back({40.0, 41.0});
    MetricResult smooth;
    smooth.id = "sparc";
    smooth.direction = Direction::higher;
    smooth.absence = Absence::not_measured;
    smooth.absent_because = {StatementId::few_movements, {{"count", 3.0}, {"least", 5.0}}};
    scored.metrics = {path, smooth};
    GateResult gate;
    gate.metric = "path_len";
    gate.hand = "left";
    gate.tissue = "areolar";
    gate.value = 812.5;
    gate.unit = "mm";
    gate.limit = 900.0;
    gate.limit_source = "A2-provisional@1";
    gate.z = -0.5;
    gate.points = 100.0;
    gate.passed = true;
    gate.provisional = true;
    GateResult open;
    open.metric = "sparc";
    open.kind = GateKind::absolute;
    open.absent_because = Statement(StatementId::no_benchmark);
    scored.score.gates = {gate, open};
    scored.score.critical_errors.push_back({"perforation", "right", "bowel", 12.5});

    const database::ScoreRow stored = to_row(scored, "A2-provisional@1");
    ScoredAttempt read;
    for (const database::MetricRow& row : stored.metrics) read.metrics.push_back(from_row(row));
    for (const database::GateRow& row : stored.gates) read.score.gates.push_back(from_row(row));
    for (const database::CriticalErrorRow& row : stored.critical_errors)
        read.score.critical_errors.push_back(from_row(row));
    EXPECT_EQ(metrics_to_json(read.metrics), metrics_to_json(scored.metrics));
    EXPECT_EQ(gates_to_json(read.score.gates), gates_to_json(scored.score.gates));
    EXPECT_EQ(critical_errors_to_json(read.score.critical_errors),
              critical_errors_to_json(scored.score.critical_errors));
}

}  // namespace
}  // namespace fulcrum
