// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/station_key.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include "database/rows/errors.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

constexpr std::size_t seed_size = 32;
constexpr const char* heading = "Fulcrum station key 1: keep it secret, keep a copy";

/// What is signed is for this use alone.
Bytes message_of(const Bytes& row_hash) {
    constexpr char use[] = "fulcrum audit row";
    Bytes message(std::begin(use), std::end(use));
    message.insert(message.end(), row_hash.begin(), row_hash.end());
    return message;
}

[[noreturn]] void fail(const std::string& path, const Sentence& why) {
    throw StoreError(
        StoreErrorKind::failed, {QT_TRANSLATE_NOOP("errors", "%1: the key of this station: %2"), path, why},
        QT_TRANSLATE_NOOP(
            "errors",
            "make its folder readable and writable for you, or name another folder in FULCRUM_STATION_KEYS"));
}

[[noreturn]] void fail_as_damaged(const std::string& path) {
    throw StoreError(
        StoreErrorKind::failed, {QT_TRANSLATE_NOOP("errors", "%1: is not a key of a station"), path},
        QT_TRANSLATE_NOOP("errors",
                          "put its copy back; without one move the file away, and a new key is made"));
}

std::string prepared_path_of(const std::string& station_id) {
    return StationKey::path_of(station_id) + ".next";
}

void write(const std::string& path, std::int64_t first_row, const Bytes& seed,
           OutputFile::Existing existing) {
    write_output_file(
        path, std::string(heading) + "\nfrom row " + std::to_string(first_row) + "\n" + to_hex(seed) + "\n",
        existing, OutputFile::Access::owner_only);
}

void make(const std::string& path, std::int64_t next_row) {
    const QString folder = QFileInfo(QString::fromStdString(path)).path();
    if (!QDir().mkpath(folder))
        fail(path, QT_TRANSLATE_NOOP("errors", "cannot be written (its folder cannot be made)"));
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    try {
        write(path, next_row, random_bytes(seed_size), OutputFile::Existing::keep);
    } catch (const std::system_error& error) {
        // Another program of this station was first: its key is the key.
        if (error.code() != std::errc::file_exists)
            fail(path, {QT_TRANSLATE_NOOP("errors", "cannot be written (%1)"), error.code().message()});
    }
}

}  // namespace

StationKey::StationKey(Bytes seed, std::int64_t first_row)
    : seed_(std::move(seed)), public_half_(public_half_of(seed_)), first_row_(first_row) {}

std::string StationKey::path_of(const std::string& station_id) {
    const QString named = QFile::decodeName(qgetenv("FULCRUM_STATION_KEYS"));
    const QString folder = named.isEmpty()
                               ? QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
                                     QStringLiteral("/fulcrum/keys")
                               : named;
    return QFile::encodeName(folder + QLatin1Char('/') + QString::fromStdString(station_id) +
                             QStringLiteral(".key"))
        .toStdString();
}

std::optional<StationKey> StationKey::existing(const std::string& station_id) {
    return read(path_of(station_id));
}

std::optional<StationKey> StationKey::prepared(const std::string& station_id) {
    return read(prepared_path_of(station_id));
}

StationKey StationKey::prepare(const std::string& station_id, std::int64_t first_row, const Bytes& present) {
    const std::string path = prepared_path_of(station_id);
    std::optional<StationKey> left = prepared(station_id);
    try {
        if (left && left->public_half_ == present) {
            // The last rotation could not put it in its place; written over, it would be lost.
            rename_replacing(path, path_of(station_id));
            left.reset();
        }
        StationKey key(left ? left->seed_ : random_bytes(seed_size), first_row);
        write(path, first_row, key.seed_, OutputFile::Existing::replace);
        return key;
    } catch (const std::system_error& error) {
        fail(path, {QT_TRANSLATE_NOOP("errors", "cannot be written (%1)"), error.code().message()});
    }
}

void StationKey::adopt_prepared(const std::string& station_id) noexcept {
    try {
        rename_replacing(prepared_path_of(station_id), path_of(station_id));
    } catch (const std::exception&) {
        // Another program has done it, or of() will.
    }
}

std::optional<StationKey> StationKey::read(const std::string& path) {
    QFile file(QFile::decodeName(QByteArray::fromStdString(path)));
    if (!file.exists()) return std::nullopt;
    if (!file.open(QIODevice::ReadOnly))
        fail(path, {QT_TRANSLATE_NOOP("errors", "cannot be read (%1)"), file.errorString().toStdString()});
    constexpr qint64 longest = 4096;
    const QList<QByteArray> lines = file.read(longest).split('\n');
    const QByteArray from = QByteArrayLiteral("from row ");
    if (lines.size() != 4 || lines[0] != heading || !lines[1].startsWith(from)) fail_as_damaged(path);
    bool is_number = false;
    const std::int64_t first_row = lines[1].mid(from.size()).toLongLong(&is_number);
    const QByteArray seed = QByteArray::fromHex(lines[2]);
    if (!is_number || first_row < 1 || seed.toHex() != lines[2] || seed.size() != static_cast<int>(seed_size))
        fail_as_damaged(path);
    return StationKey({seed.begin(), seed.end()}, first_row);
}

StationKey StationKey::of(const std::string& station_id, std::int64_t next_row, const Bytes& expected) {
    std::optional<StationKey> key = existing(station_id);
    if (!expected.empty() && (!key || key->public_half_ != expected)) {
        std::optional<StationKey> next = prepared(station_id);
        if (next && next->public_half_ == expected) {
            adopt_prepared(station_id);
            return *std::move(next);
        }
        // Between the two readings another program may have put the new key in its place.
        key = existing(station_id);
    }
    if (key) return *std::move(key);
    make(path_of(station_id), next_row);
    key = existing(station_id);
    if (key) return *std::move(key);
    fail(path_of(station_id), QT_TRANSLATE_NOOP("errors", "was removed while it was being made"));
}

Bytes StationKey::sign(const Bytes& row_hash) const {
    return database::sign(seed_, message_of(row_hash));
}

Bytes StationKey::sign_enrolment(const std::string& statement) const {
    // Its first line is the use, which no message about an audit row has.
    return database::sign(seed_, Bytes(statement.begin(), statement.end()));
}

std::string key_fingerprint(const Bytes& public_half) {
    return to_hex(blake2b(public_half, 16));
}

bool row_signature_holds(const Bytes& public_half, const Bytes& row_hash, const Bytes& signature) {
    return signature_holds(public_half, message_of(row_hash), signature);
}

bool enrolment_signature_holds(const Bytes& public_half, const std::string& statement,
                               const Bytes& signature) {
    return signature_holds(public_half, Bytes(statement.begin(), statement.end()), signature);
}

}  // namespace fulcrum::database
