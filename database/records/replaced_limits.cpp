// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/replaced_limits.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace fulcrum::database {
namespace {

/// The set that was in force when the attempt began; without a digest where its files were not kept (older
/// programs).
AssetFile set_of(Connection& connection, const std::string& attempt_id) {
    Query row(connection,
              "SELECT file, digest FROM attempt_asset WHERE attempt_id = ? AND substr(file, 1, 11) = "
              "'benchmarks/' ORDER BY file");
    row.bind(attempt_id);
    return row.next() ? AssetFile{row.text(0), row.text(1)} : AssetFile();
}

/// As the set itself says, where the programme keeps what accepted files say.
std::optional<bool> as_kept(Connection& connection, const std::string& digest) {
    Query row(connection, "SELECT text FROM asset_text WHERE digest = ?");
    row.bind(digest);
    if (!row.next()) return std::nullopt;
    const QJsonValue said = QJsonDocument::fromJson(QByteArray::fromStdString(row.text(0)))
                                .object()
                                .value(QLatin1String("provisional"));
    return said.isBool() ? std::optional<bool>(said.toBool()) : std::nullopt;
}

/// As the gates of an attempt have it that this set judged: the score in force is by the set of the start.
constexpr const char* judged =
    "JOIN gate g ON g.score_id = s.id AND g.kind = 'benchmark' AND g.limit_value IS NOT NULL ";

}  // namespace

std::optional<bool> ReplacedLimits::is_provisional(const AssetFile& set, const std::string& name) {
    if (const std::optional<bool> kept = as_kept(connection_, set.digest)) return kept;
    const bool by_file = !set.digest.empty();
    Query row(connection_, by_file ? QString("SELECT g.provisional FROM attempt_asset o JOIN score s ON "
                                             "s.attempt_id = o.attempt_id AND s.in_force = 1 %1WHERE "
                                             "o.digest = ? AND o.file = ? LIMIT 1")
                                         .arg(judged)
                                   : QString("SELECT g.provisional FROM score s %1WHERE s.in_force = 1 AND "
                                             "s.limits = ? AND s.limits <> '' LIMIT 1")
                                         .arg(judged));
    if (by_file)
        row.bind(set.digest).bind(set.name);
    else
        row.bind(name);
    return row.next() ? std::optional<bool>(row.flag(0)) : std::nullopt;
}

void ReplacedLimits::decide(AttemptSummary& attempt) {
    const AssetFile set = set_of(connection_, attempt.meta.id);
    const auto [entry, is_new] = known_.try_emplace({set.digest, attempt.meta.limits});
    if (is_new) entry->second = is_provisional(set, attempt.meta.limits);
    attempt.provisional = entry->second.value_or(false);
    attempt.without_limits = !entry->second.has_value();
}

}  // namespace fulcrum::database
